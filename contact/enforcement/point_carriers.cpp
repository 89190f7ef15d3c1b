// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/point_carriers.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

namespace contactsim {

bool PointCarriers::find_plain(const ContactPoint& contact_point, Terms& terms, Weights& weights) const {
  const auto find_side = [&](const ContactPointSide& side, double sign, std::size_t first_corner) {
    for (std::size_t k = 0; k < 4; ++k) {
      const double weight = side.weights[static_cast<Eigen::Index>(k)];
      if (weight == 0.0) continue;
      std::uint8_t& term = terms.of_corners[first_corner + k];
      if (term == 0) {
        const std::optional<std::uint32_t> carrier = mobility_.plain_carrier(side.nodes[k]);
        if (!carrier) return false;
        terms.carriers[terms.n_terms++] = *carrier;
        term = static_cast<std::uint8_t>(terms.n_terms);
      }
      weights[term - 1u] = sign * weight;
    }
    return true;
  };
  return find_side(contact_point.first, 1.0, 0) && find_side(contact_point.second, -1.0, 4);
}

void PointCarriers::find_general(const ContactPoint& contact_point, Terms& terms, Weights& weights) {
  terms.n_terms = 0;
  terms.first_arm = static_cast<std::uint32_t>(arms_.size());
  const auto add_side = [&](const ContactPointSide& side, double sign) {
    found_.clear();
    const Eigen::Vector3d beside = -sign * side.radius * contact_point.normal;
    for (std::size_t k = 0; k < 4; ++k) {
      const double weight = side.weights[static_cast<Eigen::Index>(k)];
      if (weight != 0.0) mobility_.add_terms(side.nodes[k], sign * weight, beside, found_);
    }
    for (const CarrierTerm& term : found_) {
      terms.carriers[terms.n_terms] = term.carrier;
      weights[terms.n_terms++] = term.weight;
      arms_.push_back(term.weight * term.arm);
    }
  };
  add_side(contact_point.first, 1.0);
  add_side(contact_point.second, -1.0);
}

double PointCarriers::turn_size(std::uint32_t carrier, std::uint32_t arm, const Direction& direction) const {
  if (direction.has_friction) return mobility_.turn_bound(carrier) * arms_[arm].norm();
  return mobility_.turn_root(carrier, arms_[arm].cross(Eigen::Vector3d(direction.normal.head<3>())));
}

void PointCarriers::add_areas(const Terms& terms, const Weights& weights, const Direction& direction,
                              double area, LeaningAreas& areas) const {
  for (std::size_t i = 0; i < terms.n_terms; ++i) areas[terms.carriers[i]][0] += area * std::abs(weights[i]);
  if (!terms.first_arm) return;
  for (std::uint32_t i = 0; i < terms.n_terms; ++i)
    areas[terms.carriers[i]][1] += area * turn_size(terms.carriers[i], *terms.first_arm + i, direction);
}

double PointCarriers::share(const Terms& terms, const Weights& weights, std::size_t term,
                            const Direction& direction, const LeaningAreas& areas) const {
  const std::uint32_t carrier = terms.carriers[term];
  const double moves = mobility_.translation_bound(carrier) * std::abs(weights[term]) * areas[carrier][0];
  if (!terms.first_arm) return moves;
  return moves + turn_size(carrier, *terms.first_arm + static_cast<std::uint32_t>(term), direction) *
                     areas[carrier][1];
}

void PointCarriers::add_loads(const Terms& terms, const Weights& weights, const Direction& direction,
                              double area, const LeaningAreas& areas, std::vector<CarrierLoad>& loads) const {
  const auto side = [&](std::size_t term) { return std::size_t{weights[term] > 0.0 ? 0u : 1u}; };
  std::array<double, 2> sides{};
  for (std::size_t i = 0; i < terms.n_terms; ++i)
    sides[side(i)] += share(terms, weights, i, direction, areas);
  for (std::size_t i = 0; i < terms.n_terms; ++i) {
    CarrierLoad& load = loads[terms.carriers[i]];
    load.own += sides[side(i)];
    load.others += sides[1 - side(i)];
    load.area += area * std::abs(weights[i]);
  }
}

}  // namespace contactsim

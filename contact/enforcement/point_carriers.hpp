// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/enforcement/constraint_pass.hpp"
#include "contact/enforcement/node_mobility.hpp"
#include "contact/enforcement/push_lists.hpp"
#include "contact/geometry/contact_point.hpp"
#include "core/base/optional_index.hpp"

namespace contactsim {

/// The carriers that contact points lean on, point by point: nodes, rigid bodies, what lofts hang on. A plain
/// carrier moves as the point does; others turn as well, about an arm.
class PointCarriers {
 public:
  static constexpr std::size_t max_terms = 8;

  /// Shares of a point's carriers, those of the second side negative [1].
  using Weights = std::array<double, max_terms>;
  /// The carriers of points between the same entities.
  struct Terms {
    std::array<std::uint32_t, max_terms> carriers{};
    std::uint32_t n_terms = 0;
    OptionalIndex<std::uint32_t> first_arm;  ///< of the carriers; none where all are plain
    /// Of plain carriers: the term of each corner, those of the second side behind; 0 without, else 1 more.
    std::array<std::uint8_t, max_terms> of_corners{};
  };
  /// Along which forces of a point its carriers turn.
  struct Direction {
    const NodeVector& normal;   ///< unit [1]
    bool has_friction = false;  ///< forces along the surface, too
  };

  explicit PointCarriers(NodeMobility& mobility) : mobility_(mobility) {}

  /// Begins a step.
  void begin() { arms_.clear(); }
  /// Finds a point's shares of plain carriers, beside those that the terms have. Returns whether that is all.
  bool find_plain(const ContactPoint& contact_point, Terms& terms, Weights& weights) const;
  /// Finds the carriers of a point of any kind.
  void find_general(const ContactPoint& contact_point, Terms& terms, Weights& weights);

  /// The arm of a term that has one, times its weight [length].
  const Eigen::Vector3d& arm(const Terms& terms, std::size_t term) const {
    return arms_[*terms.first_arm + term];
  }
  /// How far a force of 1 turns a carrier by one of the arms, at the point and as a square root.
  double turn_size(std::uint32_t carrier, std::uint32_t arm, const Direction& direction) const;
  /// Adds a point's area to those of its carriers.
  void add_areas(const Terms& terms, const Weights& weights, const Direction& direction, double area,
                 LeaningAreas& areas) const;
  /// What a carrier adds to the softness of a point, times its area over the step.
  double share(const Terms& terms, const Weights& weights, std::size_t term, const Direction& direction,
               const LeaningAreas& areas) const;
  /// Adds a point to what leans on its carriers.
  void add_loads(const Terms& terms, const Weights& weights, const Direction& direction, double area,
                 const LeaningAreas& areas, std::vector<CarrierLoad>& loads) const;

  /// Change of the first side's velocity against the second's by the forces of the last pass [length/time].
  NodeVector change(const Terms& terms, const Weights& weights) const;
  /// Pushes the carriers by a force on the first side, and its opposite on the second.
  void push(const Terms& terms, const Weights& weights, const NodeVector& force);

  std::size_t n_carriers() const { return mobility_.n_carriers(); }
  /// Calls take(carrier, push) for each carrier of a row that such a force pushes.
  template <class Take>
  void visit_pushes(const Terms& terms, const Weights& weights, std::uint32_t row, const Take& take) const;
  /// Pushes one of them by all its rows.
  ///   forces  [n_rows]
  void push(std::uint32_t carrier, std::span<const RowPush> pushes, std::span<const NodeVector> forces);

 private:
  NodeMobility& mobility_;
  std::vector<Eigen::Vector3d> arms_;  // of carriers that are not plain, times the weight [length]
  std::vector<CarrierTerm> found_;     // scratch
};

inline NodeVector PointCarriers::change(const Terms& terms, const Weights& weights) const {
  NodeVector sum = NodeVector::Zero();
  for (std::size_t i = 0; i < terms.n_terms; ++i) sum += weights[i] * mobility_.change(terms.carriers[i]);
  if (!terms.first_arm) return sum;
  for (std::size_t i = 0; i < terms.n_terms; ++i)
    sum.head<3>() += mobility_.turning(terms.carriers[i]).cross(arm(terms, i));
  return sum;
}

inline void PointCarriers::push(const Terms& terms, const Weights& weights, const NodeVector& force) {
  if (force.isZero(0.0)) return;
  if (!terms.first_arm) {
    for (std::size_t i = 0; i < terms.n_terms; ++i)
      mobility_.push_plain(terms.carriers[i], weights[i] * force);
    return;
  }
  const Eigen::Vector3d whole = force.head<3>();
  for (std::size_t i = 0; i < terms.n_terms; ++i)
    mobility_.push(terms.carriers[i], weights[i] * whole, arm(terms, i).cross(whole));
}

template <class Take>
void PointCarriers::visit_pushes(const Terms& terms, const Weights& weights, std::uint32_t row,
                                 const Take& take) const {
  for (std::uint32_t i = 0; i < terms.n_terms; ++i) {
    RowPush push{weights[i], row, {}};
    if (terms.first_arm) push.arm = *terms.first_arm + i;
    take(terms.carriers[i], push);
  }
}

inline void PointCarriers::push(std::uint32_t carrier, std::span<const RowPush> pushes,
                                std::span<const NodeVector> forces) {
  const double mobility = mobility_.translation_bound(carrier);
  NodeVector pushed = mobility_.pushed(carrier);
  for (const RowPush& push : pushes) {
    const NodeVector& force = forces[push.row];
    if (!push.arm) {
      pushed += mobility * (push.weight * force);
    } else if (!force.isZero(0.0)) {
      mobility_.pushed(carrier) = pushed;
      const Eigen::Vector3d whole = force.head<3>();
      mobility_.push(carrier, push.weight * whole, arms_[*push.arm].cross(whole));
      pushed = mobility_.pushed(carrier);
    }
  }
  mobility_.pushed(carrier) = pushed;
}

}  // namespace contactsim

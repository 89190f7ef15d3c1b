// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/tie_constraints.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace contactsim {

namespace {

/// By how much a matrix lengthens vectors at most, the same in every frame.
double bound_of(const Eigen::Matrix3d& matrix) {
  if (matrix.isDiagonal(0.0)) return matrix.diagonal().cwiseAbs().maxCoeff();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> squares(matrix.transpose() * matrix,
                                                               Eigen::EigenvaluesOnly);
  return std::sqrt(squares.eigenvalues().maxCoeff());
}

}  // namespace

void TieConstraints::begin(const ContactKinematics& kinematics, double dt) {
  kinematics_ = &kinematics;
  dt_ = dt;
  rows_.clear();
  terms_.clear();
}

TieConstraints::Sides TieConstraints::sides_of(const Tie& tie) const {
  Sides sides;
  for (std::size_t k = 0; k < 8; ++k)
    sides.x.col(static_cast<Eigen::Index>(k)) = kinematics_->x(tie.nodes[k]);
  sides.second = sides.x.rightCols<4>();
  sides.axes = axes_of(sides.second);
  return sides;
}

/// Points that stand for no area, nodes whose faces lie beside the other side, hold nothing.
void TieConstraints::add(Tie& tie) {
  const Sides sides = sides_of(tie);
  for (std::uint32_t p = 0; p < tie.n_points; ++p) {
    if (tie.points[p].area > 0.0) add_point(tie, p, sides);
  }
}

void TieConstraints::add_term(std::uint32_t carrier, const Eigen::Matrix3d& weight,
                              const Eigen::Vector3d& arm) {
  terms_.push_back({carrier, weight, arm, bound_of(weight)});
}

void TieConstraints::add_first_terms(const Tie& tie, const TiePoint& point) {
  carriers_.clear();
  for (std::size_t k = 0; k < 4; ++k) {
    const double weight = point.weights_1[static_cast<Eigen::Index>(k)];
    if (weight != 0.0) mobility_.add_terms(tie.nodes[k], weight, Eigen::Vector3d::Zero(), carriers_);
  }
  for (const CarrierTerm& term : carriers_)
    add_term(term.carrier, term.weight * Eigen::Matrix3d::Identity(), term.arm);
}

void TieConstraints::add_second_terms(const Tie& tie, const TiePoint& point, const Eigen::Vector3d& offset,
                                      const std::array<Eigen::Matrix3d, 4>& transferred) {
  carriers_.clear();
  for (std::size_t k = 0; k < 4; ++k) {
    const double weight = point.weights_2[static_cast<Eigen::Index>(k)];
    if (weight != 0.0) mobility_.add_terms(tie.nodes[k + 4], weight, Eigen::Vector3d::Zero(), carriers_);
  }
  if (carriers_.size() == 1) {
    // One carrier, such as a rigid body, carries the point as it is.
    const CarrierTerm& term = carriers_.front();
    add_term(term.carrier, -Eigen::Matrix3d::Identity(), term.arm + offset);
    return;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    if (transferred[k].isZero(0.0)) continue;
    carriers_.clear();
    mobility_.add_terms(tie.nodes[k + 4], 1.0, Eigen::Vector3d::Zero(), carriers_);
    add_term(carriers_[0].carrier, -transferred[k], carriers_[0].arm);
  }
}

void TieConstraints::add_point(Tie& tie, std::uint32_t index, const Sides& sides) {
  const TiePoint& point = tie.points[index];
  const Eigen::Vector3d offset = offset_of(point, sides.x);
  const auto transferred = carry_point(sides.second, point.weights_2, offset);
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < 4; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    velocity +=
        point.weights_1[i] * kinematics_->v(tie.nodes[k]) - transferred[k] * kinematics_->v(tie.nodes[k + 4]);
  }
  Row& row = rows_.emplace_back();
  row.tie = &tie;
  row.point = index;
  row.first_term = static_cast<std::uint32_t>(terms_.size());
  add_first_terms(tie, point);
  add_second_terms(tie, point, offset, transferred);
  row.n_terms = static_cast<std::uint32_t>(terms_.size()) - row.first_term;
  row.start = offset - sides.axes * point.offset + dt_ * velocity;
  row.force = taken_over * sides.axes * point.force;
}

double TieConstraints::turn_size(const Term& term) const {
  return mobility_.turn_bound(term.carrier) * term.bound * term.arm.norm();
}

void TieConstraints::add_areas(LeaningAreas& areas) const {
  for (const Row& row : rows_) {
    const double area = area_of(row);
    for (const Term& term : terms_of(row)) {
      areas[term.carrier][0] += area * term.bound;
      areas[term.carrier][1] += area * turn_size(term);
    }
  }
}

double TieConstraints::share(const Term& term, const LeaningAreas& areas) const {
  return mobility_.translation_bound(term.carrier) * term.bound * areas[term.carrier][0] +
         turn_size(term) * areas[term.carrier][1];
}

void TieConstraints::add_loads(const LeaningAreas& areas, std::vector<CarrierLoad>& loads) const {
  for (const Row& row : rows_) {
    std::array<double, 2> sides{};
    const auto side = [](const Term& term) { return term.weight.trace() > 0.0 ? 0 : 1; };
    for (const Term& term : terms_of(row)) sides[side(term)] += share(term, areas);
    for (const Term& term : terms_of(row)) {
      CarrierLoad& load = loads[term.carrier];
      load.own += sides[side(term)];
      load.others += sides[1 - side(term)];
      load.area += area_of(row) * term.bound;
    }
  }
}

void TieConstraints::set_softness(const LeaningAreas& areas, const LightCarriers& light, double least) {
  for (Row& row : rows_) {
    double gap = 0.0;
    bool has_light = false;
    for (const Term& term : terms_of(row)) {
      const bool is_light = light.is_light(term.carrier);
      has_light = has_light || is_light;
      if (!is_light) gap += share(term, areas);
    }
    if (has_light) gap = std::max(gap, least * area_of(row));
    row.softness = dt_ * gap / area_of(row);
  }
  std::erase_if(rows_, [](const Row& row) { return !(row.softness > 0.0); });
}

void TieConstraints::add_rows(LightCarriers& light) {
  std::vector<LightShare> shares;
  light_points_.clear();
  for (std::uint32_t i = 0; i < rows_.size(); ++i) {
    shares.clear();
    for (const Term& term : terms_of(rows_[i])) {
      if (light.is_light(term.carrier)) shares.push_back({light.of(term.carrier), term.weight, term.arm});
    }
    if (shares.empty()) continue;
    rows_[i].light = light.add_row(shares);
    light_points_.push_back(i);
  }
}

LightAnswer TieConstraints::answer(std::uint32_t light_point, const Eigen::Vector3d& velocity) const {
  const Row& row = rows_[light_points_[light_point]];
  const Eigen::Vector3d force = next_force(row, dt_ * (change(row) + velocity));
  const double rate = dt_ * (1.0 - constraint_compliance) / row.softness;
  return {force, force - row.ahead, rate * Eigen::Matrix3d::Identity(), rate};
}

Eigen::Vector3d TieConstraints::change(const Row& row) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Term& term : terms_of(row)) {
    const Eigen::Vector3d moved = mobility_.change(term.carrier).head<3>();
    sum += term.weight * (moved + mobility_.turning(term.carrier).cross(term.arm));
  }
  return sum;
}

void TieConstraints::push(const Row& row) {
  for (const Term& term : terms_of(row)) {
    const Eigen::Vector3d own = term.weight.transpose() * row.ahead;
    mobility_.push(term.carrier, own, term.arm.cross(own));
  }
}

void TieConstraints::push_forces() {
  for (Row& row : rows_) {
    row.ahead = row.force;
    push(row);
  }
}

///   changed  by which the forces of the last pass change the distance [length]
Eigen::Vector3d TieConstraints::next_force(const Row& row, const Eigen::Vector3d& changed) const {
  const Eigen::Vector3d distance = row.start + changed + constraint_compliance * row.softness * row.ahead;
  return row.ahead - (1.0 - constraint_compliance) / row.softness * distance;
}

ConstraintPass TieConstraints::pass(double momentum, const LightCarriers& light) {
  ConstraintPass sums;
  for (Row& row : rows_) {
    Eigen::Vector3d velocity = change(row);
    if (row.light) velocity += light.velocity(*row.light);
    sums.take(row, next_force(row, dt_ * velocity), momentum);
    push(row);
  }
  return sums;
}

void TieConstraints::finish() {
  for (const Row& row : rows_) {
    const Eigen::Matrix3d axes = sides_of(*row.tie).axes;
    row.tie->points[row.point].force = axes.transpose() * row.force;
  }
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_assembler.hpp"

#include <algorithm>

#include "core/base/state_archive.hpp"

namespace contactsim {

ContactAssembler::ContactAssembler(std::size_t n_nodes, std::size_t n_pairs, bool has_friction,
                                   bool has_moments)
    : has_friction_(has_friction),
      has_moments_(has_moments),
      nodes_(n_nodes, NodeVector::Zero()),
      moments_(has_moments ? n_nodes : 0, Eigen::Vector3d::Zero()),
      pairs_(n_pairs),
      friction_(has_friction ? n_nodes : 0),
      slips_(has_friction ? n_nodes : 0, NodeVector::Zero()),
      work_(n_pairs) {}

void ContactAssembler::archive(StateArchive& saved) {
  work_.archive(saved);
  saved.fixed_rows("contact/nodes/friction", friction_, [](NodeFriction& node, RowNumbers& row) {
    row(node.slip, node.slip_length, node.energy, node.last_slip);
  });
}

void ContactAssembler::remap(const ContactRemap& remap) {
  work_.forget_forces();
  transfer(remap.nodes, remap.n_nodes_after, NodeVector(NodeVector::Zero()), nodes_);
  transfer(remap.nodes, remap.n_nodes_after, NodeFriction{}, friction_);
  transfer(remap.nodes, remap.n_nodes_after, NodeVector(NodeVector::Zero()), slips_);
  nodes_.resize(remap.n_nodes_after, NodeVector::Zero());
  moments_.assign(has_moments_ ? remap.n_nodes_after : 0, Eigen::Vector3d::Zero());
  friction_.resize(has_friction_ ? remap.n_nodes_after : 0);
  slips_.resize(has_friction_ ? remap.n_nodes_after : 0, NodeVector::Zero());
}

void ContactAssembler::begin_step() {
  dissipated_ = damped_ = 0.0;
  std::fill(nodes_.begin(), nodes_.end(), NodeVector::Zero());
  std::fill(moments_.begin(), moments_.end(), Eigen::Vector3d::Zero());
  std::fill(slips_.begin(), slips_.end(), NodeVector::Zero());
  std::fill(pairs_.begin(), pairs_.end(), PairStep{});
}

void ContactAssembler::add(const ContactPoint& point) {
  NodeVector on_first, on_second;
  const Eigen::Vector3d force = point.force_on_first();
  on_first << force, point.stiffness;
  on_second << -force, point.stiffness;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    nodes_[point.first.nodes[k]] += point.first.weights[i] * on_first;
    nodes_[point.second.nodes[k]] += point.second.weights[i] * on_second;
  }
  add_moment(point.first, -point.first.radius * point.normal, force);
  add_moment(point.second, point.second.radius * point.normal, -force);
  PairStep& pair = pairs_[point.pair];
  pair.is_near = true;
  if (!point.touches()) return;
  pair.force += point.is_swapped ? Eigen::Vector3d(-force) : force;
  pair.area += point.area;
  pair.stored += point.stored();
  pair.dissipated += point.dissipated;
  pair.damped += point.damped;
  pair.impact += point.impact;
  pair.touches = true;
  if (kinematics_ != nullptr) work_.add(*kinematics_, point);
  if (!point.is_balanced) dissipated_ += point.dissipated;
  damped_ += point.damped;
  if (friction_.empty()) return;
  add_slip(point.first, point.slip, point);
  add_slip(point.second, -point.slip, point);
}

void ContactAssembler::note_penetration(const ContactPoint& point, double thickness) {
  PairStep& pair = pairs_[point.pair];
  if (point.force <= 0.0 || !(-point.open_gap() > pair.penetration)) return;
  pair.penetration = -point.open_gap();
  pair.penetration_share = -point.open_gap() / thickness;
}

void ContactAssembler::add_moment(const ContactPointSide& side, const Eigen::Vector3d& arm,
                                  const Eigen::Vector3d& force) {
  if (side.radius == 0.0) return;
  for (std::size_t k = 0; k < 4; ++k)
    moments_[side.nodes[k]] += side.weights[static_cast<Eigen::Index>(k)] * arm.cross(force);
}

void ContactAssembler::add_slip(const ContactPointSide& side, const Eigen::Vector3d& slip,
                                const ContactPoint& point) {
  NodeVector share;
  share << point.area * slip, point.area;
  for (std::size_t k = 0; k < 4; ++k) {
    const double weight = side.weights[static_cast<Eigen::Index>(k)];
    slips_[side.nodes[k]] += weight * share;
    friction_[side.nodes[k]].energy += 0.5 * weight * point.dissipated;
  }
}

void ContactAssembler::add(const InterfaceConstraint& constraint, const CornerForces& forces) {
  PairStep& pair = pairs_[constraint.pair];
  for (std::size_t k = 0; k < 8; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    nodes_[constraint.nodes[k]].head<3>() += forces.forces.col(i);
    nodes_[constraint.nodes[k]][3] += constraint.springs[i];
  }
  const Eigen::Vector3d on_first = forces.forces.leftCols<4>().rowwise().sum();
  pair.force += constraint.is_swapped ? Eigen::Vector3d(-on_first) : on_first;
  pair.area += constraint.area;
  pair.stored += forces.stored;
  pair.dissipated += forces.dissipated;
  dissipated_ += forces.dissipated;
  if (kinematics_ != nullptr) work_.add(*kinematics_, constraint, forces);
  pair.touches = pair.is_near = true;
}

void ContactAssembler::end_step() {
  for (std::size_t i = 0; i < friction_.size(); ++i) {
    const double area = slips_[i][3];
    friction_[i].last_slip =
        area > 0.0 ? Eigen::Vector3d(slips_[i].head<3>() / area) : Eigen::Vector3d::Zero();
    friction_[i].slip += friction_[i].last_slip;
    friction_[i].slip_length += friction_[i].last_slip.norm();
  }
}

}  // namespace contactsim

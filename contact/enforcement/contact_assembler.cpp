// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_assembler.hpp"

#include <algorithm>

#include "core/base/state_archive.hpp"
#include "core/base/threads.hpp"

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
      met_(has_friction ? n_nodes : 0),
      partners_(has_friction ? n_nodes : 0),
      work_(n_pairs) {}

void ContactAssembler::archive(StateArchive& saved) {
  work_.archive(saved);
  saved.fixed_rows("contact/nodes/friction", friction_, [](NodeFriction& node, RowNumbers& row) {
    row(node.slip, node.slip_length, node.energy, node.last_slip);
  });
  saved.list("contact/nodes/slip_partners", partners_);
}

void ContactAssembler::remap(const ContactRemap& remap) {
  work_.forget_forces();
  transfer(remap.nodes, remap.n_nodes_after, NodeVector(NodeVector::Zero()), nodes_);
  transfer(remap.nodes, remap.n_nodes_after, NodeFriction{}, friction_);
  transfer(remap.nodes, remap.n_nodes_after, NodeVector(NodeVector::Zero()), slips_);
  for (OptionalIndex<ContactNodeIndex>& partner : partners_) {
    if (partner) partner = remap.nodes[*partner];
  }
  transfer(remap.nodes, remap.n_nodes_after, OptionalIndex<ContactNodeIndex>(), partners_);
  nodes_.resize(remap.n_nodes_after, NodeVector::Zero());
  moments_.assign(has_moments_ ? remap.n_nodes_after : 0, Eigen::Vector3d::Zero());
  friction_.resize(has_friction_ ? remap.n_nodes_after : 0);
  slips_.resize(has_friction_ ? remap.n_nodes_after : 0, NodeVector::Zero());
  met_.assign(has_friction_ ? remap.n_nodes_after : 0, OptionalIndex<ContactNodeIndex>());
  partners_.resize(has_friction_ ? remap.n_nodes_after : 0);
}

void ContactAssembler::begin_step() {
  dissipated_ = damped_ = 0.0;
  std::fill(nodes_.begin(), nodes_.end(), NodeVector::Zero());
  std::fill(moments_.begin(), moments_.end(), Eigen::Vector3d::Zero());
  std::fill(slips_.begin(), slips_.end(), NodeVector::Zero());
  std::fill(met_.begin(), met_.end(), OptionalIndex<ContactNodeIndex>());
  std::fill(pairs_.begin(), pairs_.end(), PairStep{});
}

void ContactAssembler::add_forces(const ContactPoint& point) {
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
}

void ContactAssembler::add_node(ContactNodeIndex node, const Eigen::Vector3d& force,
                                const Eigen::Vector3d& moment) {
  nodes_[node].head<3>() += force;
  if (has_moments_) moments_[node] += moment;
}

void ContactAssembler::add(const ContactPoint& point) {
  add_forces(point);
  const Eigen::Vector3d force = point.force_on_first();
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
  add_slip(point.first, point.second, point.slip, point);
  add_slip(point.second, point.first, -point.slip, point);
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

void ContactAssembler::add_slip(const ContactPointSide& side, const ContactPointSide& other,
                                const Eigen::Vector3d& slip, const ContactPoint& point) {
  NodeVector share;
  share << point.area * slip, point.area;
  const bool is_rigid = other.weights.isZero(0.0);
  if (side.is_node() && !is_rigid) {
    Eigen::Index nearest = 0;
    other.weights.maxCoeff(&nearest);
    met_[side.nodes[0]] = other.nodes[static_cast<std::size_t>(nearest)];
  }
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

namespace {

/// The turn of the surface that a node's slip follows: its own, or without faces that of what it met last.
Eigen::Matrix3d turn_of(const ContactKinematics& now, const SurfaceTurns& turns, ContactNodeIndex node,
                        OptionalIndex<ContactNodeIndex> partner) {
  const bool has_own = turns.has_faces(node) || !partner;
  return turns.turn(now, has_own ? node : *partner);
}

}  // namespace

Eigen::Vector3d ContactAssembler::slip_now(const ContactKinematics& now, const SurfaceTurns& turns,
                                           ContactNodeIndex node) const {
  const Eigen::Vector3d& slip = friction_[node].slip;
  if (slip.isZero(0.0)) return slip;
  return turn_of(now, turns, node, partners_[node]) * slip;
}

/// A node without faces that has come to another part of a surface turns with that from now on.
void ContactAssembler::follow_partner(ContactNodeIndex node, const SurfaceTurns& turns) {
  if (!met_[node] || met_[node] == partners_[node] || turns.has_faces(node)) return;
  const Eigen::Vector3d now = slip_now(*kinematics_, turns, node);
  partners_[node] = met_[node];
  friction_[node].slip = turn_of(*kinematics_, turns, node, partners_[node]).transpose() * now;
}

void ContactAssembler::end_step(const SurfaceTurns& turns) {
  parallel_for(friction_.size(), threads_for(friction_.size()), [&](std::size_t i) {
    const ContactNodeIndex index{static_cast<std::uint32_t>(i)};
    NodeFriction& node = friction_[index];
    const double area = slips_[index][3];
    node.last_slip = area > 0.0 ? Eigen::Vector3d(slips_[index].head<3>() / area) : Eigen::Vector3d::Zero();
    if (kinematics_ != nullptr) follow_partner(index, turns);
    if (node.last_slip.isZero(0.0)) return;
    node.slip_length += node.last_slip.norm();
    node.slip += kinematics_ == nullptr
                     ? node.last_slip
                     : turn_of(*kinematics_, turns, index, partners_[index]).transpose() * node.last_slip;
  });
}

}  // namespace contactsim

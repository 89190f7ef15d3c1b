// SPDX-License-Identifier: BSD-3-Clause
#include "contact/contact_sums.hpp"

#include <algorithm>

#include "core/state_archive.hpp"

namespace contactsim {

ContactSums::ContactSums(std::size_t n_nodes, std::size_t n_pairs, bool has_friction, bool has_moments)
    : has_friction_(has_friction),
      has_moments_(has_moments),
      nodes_(n_nodes, NodeVector::Zero()),
      moments_(has_moments ? n_nodes : 0, Eigen::Vector3d::Zero()),
      pairs_(n_pairs),
      friction_(has_friction ? n_nodes : 0),
      slips_(has_friction ? n_nodes : 0, NodeVector::Zero()),
      work_(n_pairs) {}

void ContactSums::archive(StateArchive& saved) {
  work_.archive(saved);
  saved.fixed_rows("contact/nodes/friction", friction_, [](NodeFriction& node, RowNumbers& row) {
    row(node.slip, node.slip_length, node.energy, node.last_slip);
  });
}

void ContactSums::renumber(const ContactRenumbering& places) {
  work_.forget_forces();
  carry(places.nodes, places.n_nodes_after, NodeVector(NodeVector::Zero()), nodes_);
  carry(places.nodes, places.n_nodes_after, NodeFriction{}, friction_);
  carry(places.nodes, places.n_nodes_after, NodeVector(NodeVector::Zero()), slips_);
  nodes_.resize(places.n_nodes_after, NodeVector::Zero());
  moments_.assign(has_moments_ ? places.n_nodes_after : 0, Eigen::Vector3d::Zero());
  friction_.resize(has_friction_ ? places.n_nodes_after : 0);
  slips_.resize(has_friction_ ? places.n_nodes_after : 0, NodeVector::Zero());
}

void ContactSums::begin_step() {
  dissipated_ = damped_ = 0.0;
  std::fill(nodes_.begin(), nodes_.end(), NodeVector::Zero());
  std::fill(moments_.begin(), moments_.end(), Eigen::Vector3d::Zero());
  std::fill(slips_.begin(), slips_.end(), NodeVector::Zero());
  std::fill(pairs_.begin(), pairs_.end(), PairStep{});
}

void ContactSums::add(const ContactRecord& record) {
  NodeVector on_first, on_second;
  const Eigen::Vector3d force = record.force_on_first();
  on_first << force, record.stiffness;
  on_second << -force, record.stiffness;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    nodes_[record.first.nodes[k]] += record.first.weights[i] * on_first;
    nodes_[record.second.nodes[k]] += record.second.weights[i] * on_second;
  }
  add_moment(record.first, -record.first.radius * record.normal, force);
  add_moment(record.second, record.second.radius * record.normal, -force);
  PairStep& pair = pairs_[record.pair];
  pair.is_near = true;
  if (!record.touches()) return;
  pair.force += record.is_swapped ? Eigen::Vector3d(-force) : force;
  pair.area += record.area;
  pair.stored += record.stored();
  pair.dissipated += record.dissipated;
  pair.damped += record.damped;
  pair.impact += record.impact;
  pair.touches = true;
  if (surface_ != nullptr) work_.add(*surface_, record);
  if (!record.is_balanced) dissipated_ += record.dissipated;
  damped_ += record.damped;
  if (friction_.empty()) return;
  add_slip(record.first, record.slip, record);
  add_slip(record.second, -record.slip, record);
}

void ContactSums::note_penetration(const ContactRecord& record, double thickness) {
  PairStep& pair = pairs_[record.pair];
  if (record.force <= 0.0 || !(-record.gap > pair.penetration)) return;
  pair.penetration = -record.gap;
  pair.penetration_share = -record.gap / thickness;
}

void ContactSums::add_moment(const RecordSide& side, const Eigen::Vector3d& arm,
                             const Eigen::Vector3d& force) {
  if (side.radius == 0.0) return;
  for (std::size_t k = 0; k < 4; ++k)
    moments_[side.nodes[k]] += side.weights[static_cast<Eigen::Index>(k)] * arm.cross(force);
}

void ContactSums::add_slip(const RecordSide& side, const Eigen::Vector3d& slip, const ContactRecord& record) {
  NodeVector share;
  share << record.area * slip, record.area;
  for (std::size_t k = 0; k < 4; ++k) {
    const double weight = side.weights[static_cast<Eigen::Index>(k)];
    slips_[side.nodes[k]] += weight * share;
    friction_[side.nodes[k]].energy += 0.5 * weight * record.dissipated;
  }
}

void ContactSums::add(const HeldPlace& place, const TieForces& forces) {
  PairStep& pair = pairs_[place.pair];
  for (std::size_t k = 0; k < 8; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    nodes_[place.nodes[k]].head<3>() += forces.forces.col(i);
    nodes_[place.nodes[k]][3] += place.springs[i];
  }
  const Eigen::Vector3d on_first = forces.forces.leftCols<4>().rowwise().sum();
  pair.force += place.is_swapped ? Eigen::Vector3d(-on_first) : on_first;
  pair.area += place.area;
  pair.stored += forces.stored;
  pair.dissipated += forces.dissipated;
  dissipated_ += forces.dissipated;
  if (surface_ != nullptr) work_.add(*surface_, place, forces);
  pair.touches = pair.is_near = true;
}

void ContactSums::end_step() {
  for (std::size_t i = 0; i < friction_.size(); ++i) {
    const double area = slips_[i][3];
    friction_[i].last_slip =
        area > 0.0 ? Eigen::Vector3d(slips_[i].head<3>() / area) : Eigen::Vector3d::Zero();
    friction_[i].slip += friction_[i].last_slip;
    friction_[i].slip_length += friction_[i].last_slip.norm();
  }
}

}  // namespace contactsim

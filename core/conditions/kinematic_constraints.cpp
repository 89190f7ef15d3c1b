// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/kinematic_constraints.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

namespace contactsim {

namespace {

std::vector<NodeIndex> all_nodes(const Mesh& mesh, std::span<const PrescribedMotion> motions) {
  std::vector<std::uint8_t> is_constrained(mesh.n_nodes(), 0);
  for (const PrescribedMotion& motion : motions) {
    for (const NodeIndex node : motion.nodes) is_constrained[node.value] = 1;
  }
  std::vector<NodeIndex> nodes;
  for (std::uint32_t i = 0; i < is_constrained.size(); ++i) {
    if (is_constrained[i] != 0) nodes.push_back({i});
  }
  return nodes;
}

/// Adds the directions that a condition takes from a node, as the sum of their dyads. About an axis nodes
/// keep only their motion along it.
void add_taken_directions(const Direction& direction, Eigen::Matrix3d& taken) {
  if (const auto* axis = std::get_if<Axis>(&direction)) {
    taken += Eigen::Matrix3d::Identity() - axis->direction * axis->direction.transpose();
    return;
  }
  for (const Eigen::Vector3d& unit : unit_vectors(direction)) taken += unit * unit.transpose();
}

/// The projection on what is at right angles to all taken directions.
Eigen::Matrix3d projection_on_free(const Eigen::Matrix3d& taken) {
  constexpr double nothing = 1e-12;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(taken);
  Eigen::Matrix3d projection = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Vector3d axis = solver.eigenvectors().col(i);
    if (solver.eigenvalues()(i) < nothing) projection += axis * axis.transpose();
  }
  return projection;
}

}  // namespace

KinematicConstraints::KinematicConstraints(const Mesh& mesh, std::vector<PrescribedMotion> motions)
    : mesh_(&mesh), motions_(std::move(motions)), nodes_(all_nodes(mesh, motions_)) {}

std::vector<NodeIndex> KinematicConstraints::never_free() const {
  std::vector<std::uint8_t> axes(mesh_ != nullptr ? mesh_->n_nodes() : 0, 0);
  for (const PrescribedMotion& motion : motions_) {
    const auto* components = std::get_if<Components>(&motion.direction);
    if (components == nullptr || !(motion.times == ActiveTimes{})) continue;
    std::uint8_t set = 0;
    for (unsigned i = 0; i < 3; ++i)
      set = static_cast<std::uint8_t>(set | (components->is_set[i] ? 1U << i : 0U));
    for (const NodeIndex node : motion.nodes)
      axes[node.value] = static_cast<std::uint8_t>(axes[node.value] | set);
  }
  std::vector<NodeIndex> nodes;
  std::copy_if(nodes_.begin(), nodes_.end(), std::back_inserter(nodes),
               [&](NodeIndex node) { return axes[node.value] == 7; });
  return nodes;
}

std::vector<std::uint8_t> KinematicConstraints::find_active(double time) const {
  std::vector<std::uint8_t> active;
  for (const PrescribedMotion& motion : motions_) active.push_back(motion.times.is_active(time) ? 1 : 0);
  return active;
}

std::vector<FreeDirections> KinematicConstraints::find_free_directions(double time) const {
  std::vector<Eigen::Matrix3d> taken(nodes_.size(), Eigen::Matrix3d::Zero());
  for (const PrescribedMotion& motion : motions_) {
    if (!motion.times.is_active(time)) continue;
    auto place = nodes_.begin();
    for (const NodeIndex node : motion.nodes) {
      place = std::lower_bound(place, nodes_.end(), node);
      add_taken_directions(motion.direction, taken[static_cast<std::size_t>(place - nodes_.begin())]);
    }
  }
  std::vector<FreeDirections> free;
  for (std::size_t i = 0; i < nodes_.size(); ++i) free.push_back({nodes_[i], projection_on_free(taken[i])});
  return free;
}

void KinematicConstraints::constrain(const BetweenSteps& now, Eigen::Matrix3Xd& acceleration) const {
  for (const PrescribedMotion& motion : motions_) {
    if (motion.times.is_active(now.time)) motion.set_acceleration(now, *mesh_, acceleration);
  }
}

void KinematicConstraints::constrain_velocity(const BetweenSteps& start, Eigen::Matrix3Xd& velocity) const {
  for (const PrescribedMotion& motion : motions_) {
    if (motion.times.is_active(start.time)) motion.set_velocity(start, *mesh_, velocity);
  }
}

}  // namespace contactsim

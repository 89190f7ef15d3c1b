// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/external_force.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/threads.hpp"
#include "core/conditions/face_forces.hpp"
#include "core/mesh/face_geometry.hpp"

namespace contactsim {

namespace {

/// The values of a load in one step, common to all nodes or of each.
class LoadValues {
 public:
  LoadValues(const ConditionFunction& value, const Motion& motion, const Mesh& mesh)
      : value_(value),
        motion_(motion),
        fields_{mesh.coordinates(), motion.coordinates, motion.velocity},
        varies_(value.varies_in_space()),
        common_(varies_ ? 0.0 : value.at(motion.time)) {}

  bool vary() const { return varies_; }

  double at(NodeIndex node) const { return varies_ ? value_.at(motion_.time, fields_, node) : common_; }

  Eigen::Vector4d at(const std::array<NodeIndex, 4>& nodes) const {
    if (!varies_) return Eigen::Vector4d::Constant(common_);
    return {at(nodes[0]), at(nodes[1]), at(nodes[2]), at(nodes[3])};
  }

 private:
  const ConditionFunction& value_;
  const Motion& motion_;
  NodalFields fields_;
  bool varies_;
  double common_;
};

Corners corners_of(const std::array<NodeIndex, 4>& nodes, const Eigen::Matrix3Xd& values) {
  Corners corners;
  for (std::size_t a = 0; a < 4; ++a) corners.col(static_cast<Eigen::Index>(a)) = values.col(nodes[a].value);
  return corners;
}

/// How fast a face moves along its mean normal [length/time].
double normal_velocity(const Corners& corners, const Corners& velocities) {
  const Eigen::Vector3d area = area_vector(corners);
  return area.stableNormalized().dot(0.25 * velocities.rowwise().sum());
}

/// The forces of a load on a face [force].
///   value  at each corner [force/length^2]
Corners forces_of(const FaceLoad& load, const std::array<NodeIndex, 4>& face, const Eigen::Vector4d& value,
                  bool varies, const Motion& motion) {
  const Corners corners = corners_of(face, motion.coordinates);
  if (load.direction) return traction_forces(corners, value, *load.direction);
  const Corners forces = varies ? pressure_forces(corners, value) : pressure_forces(corners, value(0));
  if (load.damping == 0.0) return forces;
  const double speed = normal_velocity(corners, corners_of(face, motion.velocity));
  return forces + pressure_forces(corners, load.damping * speed);
}

/// The smaller of two node positions, one of which may be none.
std::uint32_t first_bad(const Eigen::Vector4d& values, const std::array<NodeIndex, 4>& nodes) {
  std::uint32_t first = beyond_all_nodes;
  for (std::size_t a = 0; a < 4; ++a) {
    if (!std::isfinite(values(static_cast<Eigen::Index>(a)))) first = std::min(first, nodes[a].value);
  }
  return first;
}

}  // namespace

void ExternalForce::add(FaceLoad load) {
  corner_forces_.resize(std::max(corner_forces_.size(), 4 * load.faces.size()));
  face_loads_.push_back(std::move(load));
}

void ExternalForce::add_nodes_where_place_counts(std::vector<NodeIndex>& nodes) const {
  for (const auto* loads : {&node_loads_, &node_moments_}) {
    for (const NodeLoad& load : *loads) {
      if (load.value.varies_in_space()) nodes.insert(nodes.end(), load.nodes.begin(), load.nodes.end());
    }
  }
  for (const FaceLoad& load : face_loads_) {
    for (const auto& face : load.faces) nodes.insert(nodes.end(), face.begin(), face.end());
  }
}

void ExternalForce::take_off(std::span<const std::uint8_t> alive) {
  for (FaceLoad& load : face_loads_) {
    std::vector<std::uint32_t> corners;
    std::size_t n = 0;
    for (std::size_t i = 0; i < load.sides.size(); ++i) {
      if (alive[load.sides[i].element().value] == 0) continue;
      load.sides[n] = load.sides[i];
      load.faces[n] = load.faces[i];
      for (const NodeIndex node : load.faces[n]) corners.push_back(node.value);
      ++n;
    }
    if (n == load.sides.size()) continue;
    load.sides.resize(n);
    load.faces.resize(n);
    load.sums = NodeSums(corners, mesh_->n_nodes());
  }
}

void ExternalForce::fail_at(const ConditionFunction& value, double time, NodeIndex node) const {
  value.fail(time, fmt::format("at node {}", mesh_->node_id(node)));
}

void ExternalForce::add_load(const NodeLoad& load, const Motion& motion, Eigen::Matrix3Xd& forces) const {
  const LoadValues values(load.value, motion, *mesh_);
  const auto add_at = [&](std::size_t i, double value) {
    forces.col(load.nodes[i].value) +=
        (load.masses.empty() ? value : load.masses[i] * value) * load.direction;
  };
  if (!values.vary()) {
    const double value = values.at(NodeIndex{});
    if (!std::isfinite(value) && !load.nodes.empty()) fail_at(load.value, motion.time, load.nodes.front());
    return followed_.visit_in(load.nodes, [&](std::size_t i) { add_at(i, value); });
  }
  const std::size_t n = load.nodes.size();
  const std::uint32_t bad = parallel_min(n, threads_for(n), beyond_all_nodes, [&](std::size_t i) {
    const NodeIndex node = load.nodes[i];
    const double value = values.at(node);
    add_at(i, value);
    return std::isfinite(value) ? beyond_all_nodes : node.value;
  });
  if (bad != beyond_all_nodes) fail_at(load.value, motion.time, {bad});
}

void ExternalForce::add_load(const FaceLoad& load, const Motion& motion, Eigen::Matrix3Xd& forces) {
  const LoadValues values(load.value, motion, *mesh_);
  const std::size_t n = load.faces.size();
  const std::uint32_t bad = parallel_min(n, threads_for(4 * n), beyond_all_nodes, [&](std::size_t face) {
    const Eigen::Vector4d value = values.at(load.faces[face]);
    const Corners on_corners = forces_of(load, load.faces[face], value, values.vary(), motion);
    for (Eigen::Index a = 0; a < 4; ++a)
      corner_forces_[4 * face + static_cast<std::size_t>(a)] << on_corners.col(a), 0.0;
    return first_bad(value, load.faces[face]);
  });
  if (bad != beyond_all_nodes) fail_at(load.value, motion.time, {bad});
  load.sums.add(corner_forces_, followed_, forces);
}

void ExternalForce::add_damping(const Motion& motion, const Eigen::Matrix3Xd& velocity,
                                const Eigen::RowVectorXd& mass, Eigen::Matrix3Xd& forces) const {
  if (motion.dt == 0.0) return;
  for (const NodeDamping& damping : dampings_) {
    if (!damping.times.is_active(motion.time)) continue;
    const double rate = -std::expm1(-damping.coefficient * motion.dt) / motion.dt;
    followed_.visit_in(damping.nodes, [&](std::size_t i) {
      const auto node = static_cast<Eigen::Index>(damping.nodes[i].value);
      forces.col(node) -= rate * (mass(node) * velocity.col(node));
    });
  }
}

ForceReport ExternalForce::set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) {
  if (is_empty() && forces.cols() == 0) return {};
  forces.resize(3, mesh_->n_nodes());
  followed_.set_zero(forces);
  for (const NodeLoad& load : node_loads_) {
    if (load.times.is_active(motion.time)) add_load(load, motion, forces);
  }
  for (const FaceLoad& load : face_loads_) {
    if (load.times.is_active(motion.time)) add_load(load, motion, forces);
  }
  add_damping(motion, motion.velocity, mass_, forces);
  return {};
}

void ExternalForce::set_moments(const Motion& motion, Eigen::Matrix3Xd& moments) {
  moments.resize(3, mesh_->n_nodes());
  followed_.set_zero(moments);
  for (const NodeLoad& moment : node_moments_) {
    if (moment.times.is_active(motion.time)) add_load(moment, motion, moments);
  }
  if (inertia_.cols() > 0 && motion.angular_velocity != nullptr)
    add_damping(motion, *motion.angular_velocity, inertia_, moments);
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/contact_kinematics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/mesh/contact_remap.hpp"
#include "core/base/state_archive.hpp"
#include "core/base/threads.hpp"
#include "core/dynamics/state.hpp"

namespace contactsim {

namespace {

/// The vectors of a face's corners.
template <class VectorOf>
FaceCorners gather(const std::array<ContactNodeIndex, 4>& corners, const VectorOf& vector_of) {
  FaceCorners gathered;
  for (int k = 0; k < 4; ++k) gathered.col(k) = vector_of(corners[static_cast<std::size_t>(k)]);
  return gathered;
}

}  // namespace

void ContactKinematics::move_nodes(const Motion& motion) {
  const auto n_nodes = static_cast<std::uint32_t>(contact_mesh_.n_nodes());
  spins_.update(motion.coordinates);
  last_velocity_ = &motion.velocity;
  is_foreseen_ = false;
  turning_ = last_turning_ = find_turning(motion, past_turning_);
  const auto n_lofts = static_cast<Eigen::Index>(contact_mesh_.loft.size());
  const bool was_known = x_.cols() == n_nodes;
  Eigen::Matrix3Xd lofts_before;
  if (was_known) lofts_before = x_.rightCols(n_lofts);
  x_.resize(3, n_nodes);
  const std::size_t n_mesh_points = contact_mesh_.n_mesh_points();
  constexpr double infinite = std::numeric_limits<double>::infinity();
  double moved = parallel_max(n_nodes, threads_for(n_nodes), 0.0, [&](std::uint32_t i) {
    const Eigen::Vector3d x = motion.coordinates.col(contact_mesh_.mesh_nodes[{i}].value);
    const double squared = was_known && i < n_mesh_points ? (x - x_.col(i)).squaredNorm() : 0.0;
    x_.col(i) = x;
    return squared < infinite ? squared : infinite;  // what is not a number has moved far
  });
  if (n_lofts > 0) {
    move_lofts(motion);
    if (was_known) {
      const auto lofts_moved = (x_.rightCols(n_lofts) - lofts_before).colwise().squaredNorm();
      moved = std::max(moved, lofts_moved.maxCoeff());
    }
  }
  if (was_known) path_ += std::sqrt(moved);
}

void ContactKinematics::step(const Motion& motion) {
  if (contact_mesh_.loft.size() > 0 && offsets_.cols() > 0) turn_offsets(motion);
  move_nodes(motion);
}

void ContactKinematics::foresee(const State& state) {
  const double half_steps = 0.5 * (state.dt + state.next_dt);
  const auto n_nodes = static_cast<std::uint32_t>(contact_mesh_.n_nodes());
  coming_velocity_.resize(3, n_nodes);
  parallel_for(n_nodes, threads_for(contact_mesh_.n_nodes()), [&](std::uint32_t i) {
    const auto node = static_cast<Eigen::Index>(contact_mesh_.mesh_nodes[{i}].value);
    coming_velocity_.col(i) = state.velocity.col(node) + half_steps * state.acceleration.col(node);
  });
  is_foreseen_ = true;
  turning_ = foresee_turning(state, half_steps);
  if (contact_mesh_.loft.size() > 0) find_loft_velocities();
}

ContactKinematics ContactKinematics::at(const Motion& motion) const {
  ContactKinematics moved(contact_mesh_);
  moved.offsets_ = offsets_;
  moved.spins_ = spins_;
  moved.move_nodes(motion);
  return moved;
}

/// The angular velocities of the nodes of the mesh, those of lofts by their spins. Null when none turns.
const Eigen::Matrix3Xd* ContactKinematics::find_turning(const Motion& motion,
                                                        Eigen::Matrix3Xd& turning) const {
  if (spins_.size() == 0) return motion.angular_velocity;
  if (motion.angular_velocity != nullptr) {
    turning = *motion.angular_velocity;
  } else {
    turning.setZero(3, motion.velocity.cols());
  }
  spin([&](NodeIndex node) { return motion.velocity.col(node.value); }, turning);
  return &turning;
}

/// The same in the coming step.
const Eigen::Matrix3Xd* ContactKinematics::foresee_turning(const State& state, double half_steps) {
  const NodalRotations& rotations = state.rotations;
  if (!rotations.exist() && spins_.size() == 0) return nullptr;
  coming_turning_.resize(3, state.velocity.cols());
  const auto n_nodes = static_cast<std::uint32_t>(contact_mesh_.n_nodes());
  parallel_for(n_nodes, threads_for(contact_mesh_.n_mesh_points()), [&](std::uint32_t i) {
    const auto node = static_cast<Eigen::Index>(contact_mesh_.mesh_nodes[{i}].value);
    if (rotations.exist()) {
      coming_turning_.col(node) =
          rotations.velocity.col(node) + half_steps * rotations.acceleration.col(node);
    } else {
      coming_turning_.col(node).setZero();
    }
  });
  const auto coming = [&](NodeIndex node) -> Eigen::Vector3d {
    return state.velocity.col(node.value) + half_steps * state.acceleration.col(node.value);
  };
  spin(coming, coming_turning_);
  return &coming_turning_;
}

/// Has the nodes with spins turn by how the nodes around them move.
template <class VelocityOf>
void ContactKinematics::spin(const VelocityOf& velocity_of, Eigen::Matrix3Xd& turning) const {
  parallel_for(spins_.size(), threads_for(spins_.size()), [&](std::size_t i) {
    const NodeIndex node = spins_.node(i);
    const auto around = spins_.neighbours(i);
    const Eigen::Vector3d own = turning.col(node.value), velocity = velocity_of(node);
    turning.col(node.value) =
        spins_.spin(i, own, velocity, [&](std::size_t k) { return velocity_of(around[k]); });
  });
}

MovingFace ContactKinematics::last_face(FaceIndex index) const {
  const ContactFace& face = contact_mesh_.faces[index];
  MovingFace moving = this->face(index);
  moving.v = gather(face.corners, [this](ContactNodeIndex node) { return last_v(node); });
  return moving;
}

void ContactKinematics::remap(const ContactRemap& remap, const Motion& motion) {
  const Eigen::Matrix3Xd before = std::move(offsets_);
  contact_mesh_.loft.find_offsets(motion.coordinates, shell_areas_, offsets_);
  const auto first_before = remap.nodes.next().value - static_cast<std::uint32_t>(before.cols());
  for (std::uint32_t i = 0; i < before.cols(); ++i) {
    const OptionalIndex<ContactNodeIndex> after = remap.nodes[{first_before + i}];
    if (after)
      offsets_.col(static_cast<Eigen::Index>((*after).value - contact_mesh_.n_mesh_points())) = before.col(i);
  }
}

void ContactKinematics::archive(StateArchive& saved) {
  if (contact_mesh_.loft.size() == 0) return;
  offsets_.resize(3, static_cast<Eigen::Index>(contact_mesh_.loft.size()));
  saved.fixed("contact/loft/arms", std::span(offsets_.data(), static_cast<std::size_t>(offsets_.size())));
}

void ContactKinematics::turn_offsets(const Motion& motion) {
  const auto own_of = [&](NodeIndex node) -> Eigen::Vector3d {
    if (motion.angular_velocity == nullptr) return Eigen::Vector3d::Zero();
    return motion.angular_velocity->col(node.value);
  };
  turns_.resize(spins_.size());
  parallel_for(spins_.size(), threads_for(spins_.size()), [&](std::size_t i) {
    const Eigen::Vector3d turn = motion.dt * spins_.mid_spin(i, motion.coordinates, motion.velocity,
                                                             motion.dt, own_of(spins_.node(i)));
    turns_[i] = Eigen::AngleAxisd(2.0 * std::atan(0.5 * turn.norm()), turn.stableNormalized()).matrix();
  });
  parallel_for(offsets_.cols(), threads_for(contact_mesh_.loft.size()), [&](Eigen::Index i) {
    const NodeIndex node = contact_mesh_.loft.node(static_cast<std::size_t>(i));
    const OptionalIndex<std::uint32_t> spin = spins_.find(node);
    const Eigen::Vector3d turn = motion.dt * own_of(node), offset = offsets_.col(i);
    if (spin) {
      offsets_.col(i) = turns_[*spin] * offset;
    } else if (const double angle = turn.norm(); angle > 0.0) {
      offsets_.col(i) = Eigen::AngleAxisd(angle, turn / angle) * offset;
    }
  });
}

/// Points of which nothing tells how they turn follow the normals of the shells.
void ContactKinematics::move_lofts(const Motion& motion) {
  if (offsets_.cols() == 0) {
    contact_mesh_.loft.find_offsets(motion.coordinates, shell_areas_, offsets_);
  } else if (motion.angular_velocity == nullptr) {
    contact_mesh_.loft.find_offsets(motion.coordinates, shell_areas_, normal_offsets_);
    for (Eigen::Index i = 0; i < offsets_.cols(); ++i) {
      if (!spins_.find(contact_mesh_.loft.node(static_cast<std::size_t>(i))))
        offsets_.col(i) = normal_offsets_.col(i);
    }
  }
  x_.rightCols(offsets_.cols()) += offsets_;
  find_loft_velocities();
}

void ContactKinematics::find_loft_velocities() {
  const Eigen::Index n_points = offsets_.cols();
  loft_velocity_.resize(3, n_points);
  parallel_for(n_points, threads_for(contact_mesh_.loft.size()), [&](Eigen::Index i) {
    const Eigen::Index node = contact_mesh_.loft.node(static_cast<std::size_t>(i)).value;
    const ContactNodeIndex point{static_cast<std::uint32_t>(contact_mesh_.n_mesh_points()) +
                                 static_cast<std::uint32_t>(i)};
    loft_velocity_.col(i) = node_velocity(point);
    if (turning_ == nullptr) return;
    const Eigen::Vector3d turning = turning_->col(node);
    loft_velocity_.col(i) += turning.cross(offsets_.col(i));
  });
}

void ContactKinematics::bound(Faces which) {
  bounded_ = which;
  bounds_.resize(contact_mesh_.faces.size());
  const std::size_t n = n_bounded();
  parallel_for(n, threads_for(10 * n), [&](std::size_t i) { set_bound(bounded(i)); });
}

void ContactKinematics::find_turns(double motion, IndexedVector<FaceIndex, float>& turns) const {
  turns.resize(contact_mesh_.faces.size());
  parallel_for(n_bounded(), threads_for(10 * n_bounded()), [&](std::size_t i) {
    const FaceIndex face = bounded(i);
    turns[face] = largest_turn(bounds_[face], contact_mesh_.faces[face].is_triangle(), motion);
  });
}

double ContactKinematics::largest_speed() const {
  const auto n = static_cast<std::uint32_t>(contact_mesh_.n_nodes());
  return std::sqrt(
      parallel_max(n, threads_for(n), 0.0, [&](std::uint32_t i) { return v({i}).squaredNorm(); }));
}

FaceCorners ContactKinematics::corners(const ContactFace& face) const {
  return gather(face.corners, [this](ContactNodeIndex node) { return x(node); });
}

FaceCorners ContactKinematics::velocities(const ContactFace& face) const {
  return gather(face.corners, [this](ContactNodeIndex node) { return v(node); });
}

void ContactKinematics::set_bound(FaceIndex index) {
  const ContactFace& face = contact_mesh_.faces[index];
  const SmoothFaces::Extent extent = contact_mesh_.smooth_faces.extent(index);
  bounds_[index] = FaceBound(corners(face), velocities(face), face.is_triangle(), extent.height, extent.lean);
}

MovingFace ContactKinematics::face(FaceIndex index) const {
  const ContactFace& face = contact_mesh_.faces[index];
  return {corners(face), velocities(face), face.is_triangle(), static_cast<double>(face.sharpness)};
}

Eigen::Vector3d ContactKinematics::corner_area(FaceIndex index) const {
  const ContactFace& face = contact_mesh_.faces[index];
  return area(face) / (face.is_triangle() ? 3.0 : 4.0);
}

double ContactKinematics::area_against(const SurfaceNode& node, const Eigen::Vector3d& normal,
                                       OptionalIndex<std::uint32_t> smoothing) const {
  constexpr double min_share = 0.01;
  double area = 0.0;
  bool has_faces = false;
  for (const FaceIndex face : contact_mesh_.faces_of_node.of(node.node)) {
    if (contact_mesh_.faces[face].surface != node.surface) continue;
    const Eigen::Vector3d own = corner_area(face);
    const double against = -own.dot(normal);
    const SmoothFace* round = contact_mesh_.smooth_faces.find(smoothing, face);
    // The round surface leans on its face at the corner: seen along its own normal it has all of its area.
    area += round == nullptr
                ? std::max(0.0, against)
                : round->area_ratio() * std::clamp(against * std::hypot(1.0, round->lean()), 0.0, own.norm());
    has_faces = true;
  }
  return has_faces ? std::max(area, min_share * node.area) : node.area;
}

ContactKinematics kinematics_of_mesh(const ContactMesh& contact_mesh, const Mesh& mesh) {
  ContactKinematics kinematics(contact_mesh);
  const Eigen::Matrix3Xd& any_velocity = mesh.coordinates();
  kinematics.move_nodes({0.0, 0.0, mesh.coordinates(), any_velocity});
  return kinematics;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "contact/geometry/face_bound.hpp"
#include "contact/geometry/face_face.hpp"
#include "contact/mesh/contact_mesh.hpp"
#include "contact/mesh/loft_spins.hpp"
#include "core/elements/force_term.hpp"

namespace contactsim {

class StateArchive;
struct ContactRemap;

/// The contact nodes and faces at one moment.
class ContactKinematics {
 public:
  /// The faces must outlive this.
  explicit ContactKinematics(const ContactMesh& contact_mesh) : contact_mesh_(contact_mesh) {}

  /// Takes over the positions of the nodes; their velocities are asked of the motion, which must be there as
  /// long. Bounds of faces are those of earlier then. Points of lofts stand off their nodes as they did, at
  /// first along the normals of the shells.
  void move_nodes(const Motion& motion);
  /// From now on the points of lofts turn with the mid surface about their nodes.
  void turn_by(LoftSpins spins) { spins_ = std::move(spins); }
  /// Takes over which rotations conditions hold or drive.
  void hold(const ModelFreeDirections& free) { spins_.hold(free); }
  const LoftSpins& spins() const { return spins_; }
  /// As move_nodes() at the end of a step, in which the points of lofts have turned: so they move by what the
  /// forces on them work on, and make no energy.
  void step(const Motion& motion);
  /// Has v() answer with the velocities that the coming step would have by the accelerations of now; last_v()
  /// still with those of the last.
  ///   state  at the moment of the nodes; the size of the next step is known
  void foresee(const State& state);
  /// The same nodes at another moment, without bounds of faces.
  ContactKinematics at(const Motion& motion) const;
  /// Goes over to other faces: points of lofts that are still there stand off their nodes as they did.
  ///   motion  of now
  void remap(const ContactRemap& remap, const Motion& motion);
  /// Saves or restores how the points of lofts stand off their nodes.
  void archive(StateArchive& saved);
  /// Brings the bounds of all faces, of the watched ones, or of those that are close to something, to where
  /// their nodes are.
  void bound_all() { bound(Faces::all); }
  void bound_watched() { bound(Faces::watched); }
  void bound_close() { bound(Faces::close); }
  /// The faces that may touch something until the next search.
  void watch(std::vector<FaceIndex> faces) { watched_ = std::move(faces); }
  /// Those of them that may within a range of motion.
  void watch_close(std::vector<FaceIndex> faces) { close_ = std::move(faces); }
  /// The faces whose bounds were brought up to date last, [i] of n.
  std::size_t n_bounded() const { return n_faces(bounded_); }
  FaceIndex bounded(std::size_t i) const { return face_of(bounded_, i); }

  /// By how much the normals of those faces may turn while their corners move by so much, at most.
  ///   motion  [length]
  ///   turns   [n_faces] those of these faces are set [1]
  void find_turns(double motion, IndexedVector<FaceIndex, float>& turns) const;

  /// What no contact node has moved farther than since another moment, when this was less by that [length].
  double path() const { return path_; }
  /// Of the velocities of v() [length/time].
  double largest_speed() const;

  /// The memory of positions and bounds [bytes].
  std::size_t bytes() const {
    return sizeof(double) * static_cast<std::size_t>(x_.size() + coming_velocity_.size() + offsets_.size() +
                                                     loft_velocity_.size()) +
           bytes_of(bounds_) + bytes_of(watched_) + bytes_of(close_);
  }

  const ContactMesh& contact_mesh() const { return contact_mesh_; }
  auto x(ContactNodeIndex node) const { return x_.col(node.value); }
  Eigen::Map<const Eigen::Vector3d> v(ContactNodeIndex node) const {
    const std::size_t n_mesh_points = contact_mesh_.n_mesh_points();
    return node.value < n_mesh_points
               ? node_velocity(node)
               : Eigen::Map<const Eigen::Vector3d>(loft_velocity_.data() + 3 * (node.value - n_mesh_points));
  }
  /// In the step before, whatever is foreseen [length/time].
  Eigen::Vector3d last_v(ContactNodeIndex node) const {
    Eigen::Vector3d velocity = last_velocity_->col(contact_mesh_.mesh_nodes[node].value);
    const std::size_t n_mesh_points = contact_mesh_.n_mesh_points();
    if (node.value < n_mesh_points || last_turning_ == nullptr) return velocity;
    return velocity +
           last_turning(node).cross(offsets_.col(static_cast<Eigen::Index>(node.value - n_mesh_points)));
  }
  /// The velocity of a point that turns with a node, in the step before or as foreseen [length/time].
  ///   arm  from the node to the point [length]
  Eigen::Vector3d last_velocity_beside(ContactNodeIndex node, const Eigen::Vector3d& arm) const {
    return last_turning_ == nullptr ? last_v(node) : last_v(node) + last_turning(node).cross(arm);
  }
  Eigen::Vector3d velocity_beside(ContactNodeIndex node, const Eigen::Vector3d& arm) const {
    if (turning_ == nullptr) return v(node);
    return v(node) + Eigen::Vector3d(turning_->col(contact_mesh_.mesh_nodes[node].value)).cross(arm);
  }
  /// How the surface turned in the step before about the node of the mesh that a contact node hangs on
  /// [1/time].
  Eigen::Vector3d last_turning(ContactNodeIndex node) const {
    if (last_turning_ == nullptr) return Eigen::Vector3d::Zero();
    return last_turning_->col(contact_mesh_.mesh_nodes[node].value);
  }
  /// The way from the node of the mesh to the points of lofts [3 x n_loft_points] [length].
  const Eigen::Matrix3Xd& offsets() const { return offsets_; }
  /// Brings back those of an earlier moment.
  void set_offsets(const Eigen::Matrix3Xd& offsets) { offsets_ = offsets; }
  const FaceBound& bound(FaceIndex face) const { return bounds_[face]; }
  MovingFace face(FaceIndex face) const;
  FaceCorners face_corners(FaceIndex face) const { return corners(contact_mesh_.faces[face]); }
  FaceCorners face_velocities(FaceIndex face) const { return velocities(contact_mesh_.faces[face]); }
  /// The same with the velocities of the step before, whatever is foreseen.
  MovingFace last_face(FaceIndex face) const;
  /// The area vector of a face, and the share of it that each corner has [length^2].
  Eigen::Vector3d area(const ContactFace& face) const { return area_vector(corners(face)); }
  Eigen::Vector3d corner_area(FaceIndex face) const;
  /// How much of its surface a node has as seen against a normal: the sides of an edge do not count for what
  /// its top touches. At least a hundredth of its share of the area at the start, which is that of nodes
  /// without faces.
  ///   normal     unit, towards the node [1]
  ///   smoothing  by which faces stand for round surfaces, whose areas count then
  double area_against(const SurfaceNode& node, const Eigen::Vector3d& normal,
                      OptionalIndex<std::uint32_t> smoothing = {}) const;

 private:
  enum class Faces : std::uint8_t { all, watched, close };

  FaceCorners corners(const ContactFace& face) const;
  FaceCorners velocities(const ContactFace& face) const;
  std::size_t n_faces(Faces which) const {
    return which == Faces::all       ? contact_mesh_.faces.size()
           : which == Faces::watched ? watched_.size()
                                     : close_.size();
  }
  FaceIndex face_of(Faces which, std::size_t i) const {
    return which == Faces::all       ? FaceIndex{static_cast<std::uint32_t>(i)}
           : which == Faces::watched ? watched_[i]
                                     : close_[i];
  }
  void bound(Faces which);
  void set_bound(FaceIndex face);
  void turn_offsets(const Motion& motion);
  void move_lofts(const Motion& motion);
  const Eigen::Matrix3Xd* find_turning(const Motion& motion, Eigen::Matrix3Xd& turning) const;
  const Eigen::Matrix3Xd* foresee_turning(const State& state, double half_steps);
  template <class VelocityOf>
  void spin(const VelocityOf& velocity_of, Eigen::Matrix3Xd& turning) const;
  void find_loft_velocities();
  /// Of the node of the mesh that a contact node hangs on, in the step before or as foreseen [length/time].
  Eigen::Map<const Eigen::Vector3d> node_velocity(ContactNodeIndex node) const {
    return Eigen::Map<const Eigen::Vector3d>(
        is_foreseen_ ? coming_velocity_.data() + 3 * std::size_t{node.value}
                     : last_velocity_->data() + 3 * std::size_t{contact_mesh_.mesh_nodes[node].value});
  }

  const ContactMesh& contact_mesh_;
  std::vector<FaceIndex> watched_, close_;
  Faces bounded_ = Faces::all;
  double path_ = 0.0;                              // see path()
  Eigen::Matrix3Xd x_;                             // of the contact nodes [length]
  Eigen::Matrix3Xd offsets_, loft_velocity_;       // of the points of lofts [length] [length/time]
  Eigen::Matrix3Xd shell_areas_, normal_offsets_;  // scratch
  Eigen::Matrix3Xd coming_velocity_;               // as foreseen [3 x n_contact_nodes] [length/time]
  bool is_foreseen_ = false;                       // so that it counts
  const Eigen::Matrix3Xd* turning_ = nullptr;      // of the mesh's nodes [1/time]; null when none turns
  const Eigen::Matrix3Xd *last_velocity_ = nullptr, *last_turning_ = nullptr;  // of the step before
  LoftSpins spins_;
  std::vector<Eigen::Matrix3d> turns_;              // scratch, by spins in the step before
  Eigen::Matrix3Xd coming_turning_, past_turning_;  // of the mesh's nodes where there are spins [1/time]
  IndexedVector<FaceIndex, FaceBound> bounds_;
};

/// The contact nodes where the mesh has them; velocities mean nothing. Both must outlive it.
ContactKinematics kinematics_of_mesh(const ContactMesh& contact_mesh, const Mesh& mesh);

}  // namespace contactsim

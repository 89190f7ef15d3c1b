// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/penalty_limits.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

namespace contactsim {

namespace {

/// What the stiffness behind nodes may be.
class StiffnessLimits {
 public:
  StiffnessLimits(const ContactKinematics& kinematics, const ContactMobility& mobility, double stable_step)
      : kinematics_(kinematics),
        contact_mesh_(kinematics.contact_mesh()),
        mobility_(mobility),
        rate_(4.0 * penalty_share / (stable_step * stable_step)),
        areas_(contact_mesh_.n_nodes(), Eigen::Matrix3d::Zero()) {
    for (const FaceIndex i : indices(contact_mesh_.faces)) {
      const Eigen::Vector3d share = kinematics.corner_area(i);
      normals_.push_back(share.normalized());
      for (const ContactNodeIndex corner : corners(contact_mesh_.faces[i]))
        areas_[corner] += share * normals_[i].transpose();
    }
  }

  static std::span<const ContactNodeIndex> corners(const ContactFace& face) {
    return std::span(face.corners).first(face.is_triangle() ? 3 : 4);
  }
  bool is_held(ContactNodeIndex node, const Eigen::Vector3d* normal) const {
    return mobility_.is_held(kinematics_, node, normal);
  }
  const Eigen::Vector3d& normal(FaceIndex face) const { return normals_[face]; }
  /// Whether a node is one of a rigid body or cannot be moved.
  bool is_rigid(ContactNodeIndex node) const {
    return mobility_.is_of_body(contact_mesh_, node) || is_held(node, nullptr);
  }
  bool is_rigid(ContactNodeIndex node, FaceIndex face) const {
    return mobility_.is_of_body(contact_mesh_, node) || is_held(node, &normals_[face]);
  }
  /// The most that a node may have as a corner of a face.
  double at_face(ContactNodeIndex node, FaceIndex face) const {
    if (is_held(node, &normals_[face])) return std::numeric_limits<double>::infinity();
    return rate_ * contact_mesh_.mass[node] / normals_[face].dot(areas_[node] * normals_[face]);
  }
  /// The most of a node that stands for an area on all sides.
  double all_round(ContactNodeIndex node, double area) const {
    if (is_held(node, nullptr)) return std::numeric_limits<double>::infinity();
    return rate_ * contact_mesh_.mass[node] / area;
  }

 private:
  const ContactKinematics& kinematics_;
  const ContactMesh& contact_mesh_;
  const ContactMobility& mobility_;
  double rate_;
  IndexedVector<ContactNodeIndex, Eigen::Matrix3d> areas_;  // of normal x normal, at each node [length^2]
  IndexedVector<FaceIndex, Eigen::Vector3d> normals_;
};

void limit_node(const StiffnessLimits& limits, const ContactMesh& contact_mesh, SurfaceNode& node) {
  double& stiffness = node.penalty_properties.stiffness;
  const auto own = contact_mesh.faces_of_node.of(node.node);
  node.penalty_properties.is_rigid =
      own.empty()
          ? limits.is_rigid(node.node)
          : std::ranges::all_of(own, [&](FaceIndex face) { return limits.is_rigid(node.node, face); });
  for (const FaceIndex face : own) stiffness = std::min(stiffness, limits.at_face(node.node, face));
  if (node.radius > 0.0f || node.is_free || own.empty())
    stiffness = std::min(stiffness, limits.all_round(node.node, node.area));
}

}  // namespace

void limit_stiffness(const ContactKinematics& kinematics, const ContactMobility& mobility, double stable_step,
                     ContactMesh& contact_mesh) {
  const StiffnessLimits limits(kinematics, mobility, stable_step);
  for (const FaceIndex i : indices(contact_mesh.faces)) {
    PenaltyProperties& penalty_properties = contact_mesh.faces[i].penalty_properties;
    const auto corners = StiffnessLimits::corners(contact_mesh.faces[i]);
    penalty_properties.is_rigid =
        std::ranges::all_of(corners, [&](ContactNodeIndex corner) { return limits.is_rigid(corner, i); });
    for (const ContactNodeIndex corner : corners)
      penalty_properties.stiffness = std::min(penalty_properties.stiffness, limits.at_face(corner, i));
  }
  for (ContactEdge& edge : contact_mesh.edges) {
    edge.penalty_properties.is_rigid =
        std::ranges::all_of(edge.nodes, [&](ContactNodeIndex node) { return limits.is_rigid(node); });
    for (const ContactNodeIndex node : edge.nodes)
      edge.penalty_properties.stiffness =
          std::min(edge.penalty_properties.stiffness, limits.all_round(node, edge.width * edge.width));
  }
  for (SurfaceNode& node : contact_mesh.surface_nodes) limit_node(limits, contact_mesh, node);
}

}  // namespace contactsim

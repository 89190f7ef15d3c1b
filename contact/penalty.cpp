// SPDX-License-Identifier: BSD-3-Clause
#include "contact/penalty.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace contactsim {

namespace {

/// From which penetration, over the thickness of the thinner element, the penalty gets stiffer, from which on
/// it does so no more, and how many times as stiff it is then. The largest pressure that a column bears, E
/// times 0.3 of strain, presses it in by an eighth of its elements so; a spring alone would let it through.
constexpr double first_share = 0.05, last_share = 0.25, stiffest = 100.0;

/// What is left of two things in series, such as springs.
double in_series(double a, double b) { return a * b / (a + b); }

/// The same of a property of two sides of which a rigid one has an infinite one; of two rigid ones their own.
double of_sides(const PenaltyProperties& first, const PenaltyProperties* second,
                double PenaltyProperties::*property) {
  if (second == nullptr || (second->is_rigid && !first.is_rigid)) return first.*property;
  if (first.is_rigid && !second->is_rigid) return second->*property;
  return in_series(first.*property, second->*property);
}

/// What the stiffness behind nodes may be.
class StiffnessLimits {
 public:
  StiffnessLimits(const ContactKinematics& kinematics, const ContactMobility& mobility, double stable_step)
      : surface_(kinematics),
        faces_(kinematics.contact_mesh()),
        mobility_(mobility),
        rate_(4.0 * penalty_share / (stable_step * stable_step)),
        areas_(faces_.n_nodes(), Eigen::Matrix3d::Zero()) {
    for (std::uint32_t i = 0; i < faces_.faces.size(); ++i) {
      const Eigen::Vector3d share = kinematics.corner_area(i);
      normals_.push_back(share.normalized());
      for (const std::uint32_t corner : corners(faces_.faces[i]))
        areas_[corner] += share * normals_[i].transpose();
    }
  }

  static std::span<const std::uint32_t> corners(const ContactFace& face) {
    return std::span(face.corners).first(face.is_triangle() ? 3 : 4);
  }
  bool is_held(std::uint32_t node, const Eigen::Vector3d* normal) const {
    return mobility_.is_held(surface_, node, normal);
  }
  const Eigen::Vector3d& normal(std::uint32_t face) const { return normals_[face]; }
  /// Whether a node is one of a rigid body or cannot be moved.
  bool is_rigid(std::uint32_t node) const {
    return mobility_.is_of_body(faces_, node) || is_held(node, nullptr);
  }
  bool is_rigid(std::uint32_t node, std::uint32_t face) const {
    return mobility_.is_of_body(faces_, node) || is_held(node, &normals_[face]);
  }
  /// The most that a node may have as a corner of a face.
  double at_face(std::uint32_t node, std::uint32_t face) const {
    if (is_held(node, &normals_[face])) return std::numeric_limits<double>::infinity();
    return rate_ * faces_.mass[node] / normals_[face].dot(areas_[node] * normals_[face]);
  }
  /// The most of a node that stands for an area on all sides.
  double all_round(std::uint32_t node, double area) const {
    if (is_held(node, nullptr)) return std::numeric_limits<double>::infinity();
    return rate_ * faces_.mass[node] / area;
  }

 private:
  const ContactKinematics& surface_;
  const ContactMesh& faces_;
  const ContactMobility& mobility_;
  double rate_;
  std::vector<Eigen::Matrix3d> areas_;  // of normal x normal, at each node [length^2]
  std::vector<Eigen::Vector3d> normals_;
};

void limit_node(const StiffnessLimits& limits, const ContactMesh& contact_mesh, SurfaceNode& node) {
  double& stiffness = node.penalty_properties.stiffness;
  const auto own = contact_mesh.faces_of_node.of(node.node);
  node.penalty_properties.is_rigid =
      own.empty()
          ? limits.is_rigid(node.node)
          : std::ranges::all_of(own, [&](std::uint32_t face) { return limits.is_rigid(node.node, face); });
  for (const std::uint32_t face : own) stiffness = std::min(stiffness, limits.at_face(node.node, face));
  if (node.radius > 0.0f || node.is_free || own.empty())
    stiffness = std::min(stiffness, limits.all_round(node.node, node.area));
}

}  // namespace

void limit_stiffness(const ContactKinematics& kinematics, const ContactMobility& mobility, double stable_step,
                     ContactMesh& contact_mesh) {
  const StiffnessLimits limits(kinematics, mobility, stable_step);
  for (std::uint32_t i = 0; i < contact_mesh.faces.size(); ++i) {
    PenaltyProperties& penalty_properties = contact_mesh.faces[i].penalty_properties;
    const auto corners = StiffnessLimits::corners(contact_mesh.faces[i]);
    penalty_properties.is_rigid =
        std::ranges::all_of(corners, [&](std::uint32_t corner) { return limits.is_rigid(corner, i); });
    for (const std::uint32_t corner : corners)
      penalty_properties.stiffness = std::min(penalty_properties.stiffness, limits.at_face(corner, i));
  }
  for (ContactEdge& edge : contact_mesh.edges) {
    edge.penalty_properties.is_rigid =
        std::ranges::all_of(edge.nodes, [&](std::uint32_t node) { return limits.is_rigid(node); });
    for (const std::uint32_t node : edge.nodes)
      edge.penalty_properties.stiffness =
          std::min(edge.penalty_properties.stiffness, limits.all_round(node, edge.width * edge.width));
  }
  for (SurfaceNode& node : contact_mesh.surface_nodes) limit_node(limits, contact_mesh, node);
}

PairPenalty make_pair_penalty(const PenaltyProperties& first, const PenaltyProperties* second,
                              const SurfacePair& pair) {
  // Of the thinner element. What is right in its middle, such as a sheet that stands on another's, is on
  // neither side of it.
  constexpr double deep = 0.5 * (1.0 - 1e-6);
  PairPenalty penalty;
  penalty.stiffness =
      pair.penalty_stiffness.value_or(of_sides(first, second, &PenaltyProperties::stiffness)) *
      pair.penalty_scale;
  const double mass = of_sides(first, second, &PenaltyProperties::mass_per_area);
  penalty.damping = 2.0 * pair.damping_fraction * std::sqrt(penalty.stiffness * mass);
  const double thickness = second ? std::min(first.thickness, second->thickness) : first.thickness;
  penalty.depth = pair.normal_tolerance.value_or(deep * thickness);
  if (!pair.penalty_stiffness) {
    const double start_depth = std::max(first.start_depth, second ? second->start_depth : 0.0);
    penalty.law = DepthLaw(first_share * thickness, last_share * thickness, stiffest).behind(start_depth);
  }
  return penalty;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/penalty.hpp"

#include <algorithm>
#include <cmath>

namespace contactsim {

namespace {

/// What is left of two things in series, such as springs; an absent one is rigid.
double in_series(double a, const double* b) { return b != nullptr ? a * *b / (a + *b) : a; }

}  // namespace

void limit_stiffness(const MovingSurface& surface, double stable_step, ContactFaces& faces) {
  std::vector<Eigen::Matrix3d> areas(faces.n_nodes(), Eigen::Matrix3d::Zero());  // of normal x normal
  std::vector<Eigen::Vector3d> normals;
  for (std::uint32_t i = 0; i < faces.faces.size(); ++i) {
    const Eigen::Vector3d share = surface.corner_area(i);
    normals.push_back(share.normalized());
    const auto& corners = faces.faces[i].corners;
    const std::size_t n = faces.faces[i].is_triangle() ? 3 : 4;
    for (std::size_t k = 0; k < n; ++k) areas[corners[k]] += share * normals[i].transpose();
  }
  const auto most = [&](std::uint32_t node, const Eigen::Vector3d& normal) {
    const double area = normal.dot(areas[node] * normal);
    return 4.0 * penalty_share * faces.mass[node] / (area * stable_step * stable_step);
  };
  for (std::uint32_t i = 0; i < faces.faces.size(); ++i) {
    ContactFace& face = faces.faces[i];
    for (const std::uint32_t corner : face.corners)
      face.backing.stiffness = std::min(face.backing.stiffness, most(corner, normals[i]));
  }
  const auto most_of_ball = [&](std::uint32_t node, double area) {
    return 4.0 * penalty_share * faces.mass[node] / (area * stable_step * stable_step);
  };
  for (ContactEdge& edge : faces.edges) {
    for (const std::uint32_t node : edge.nodes)
      edge.backing.stiffness = std::min(edge.backing.stiffness, most_of_ball(node, edge.width * edge.width));
  }
  for (SurfaceNode& node : faces.surface_nodes) {
    if (node.radius > 0.0f)
      node.backing.stiffness = std::min(node.backing.stiffness, most_of_ball(node.node, node.area));
    for (const std::uint32_t face : faces.faces_of_node.of(node.node))
      node.backing.stiffness = std::min(node.backing.stiffness, most(node.node, normals[face]));
    if (!node.is_free && faces.faces_of_node.of(node.node).size() > 0) continue;
    const double bearable =
        4.0 * penalty_share * faces.mass[node.node] / (node.area * stable_step * stable_step);
    node.backing.stiffness = std::min(node.backing.stiffness, bearable);
  }
}

PairPenalty make_pair_penalty(const Backing& first, const Backing* second, const SurfacePair& pair) {
  // Of the thinner element. What is right in its middle, such as a sheet that stands on another's, is on
  // neither side of it.
  constexpr double deep = 0.5 * (1.0 - 1e-6);
  PairPenalty penalty;
  penalty.stiffness =
      pair.penalty_stiffness.value_or(in_series(first.stiffness, second ? &second->stiffness : nullptr)) *
      pair.penalty_scale;
  const double mass = in_series(first.mass_per_area, second ? &second->mass_per_area : nullptr);
  penalty.damping = 2.0 * pair.damping_fraction * std::sqrt(penalty.stiffness * mass);
  const double thickness = second ? std::min(first.thickness, second->thickness) : first.thickness;
  penalty.depth = pair.normal_tolerance.value_or(deep * thickness);
  return penalty;
}

}  // namespace contactsim

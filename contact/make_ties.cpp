// SPDX-License-Identifier: BSD-3-Clause
#include "contact/make_ties.hpp"

#include <algorithm>
#include <cmath>

#include "contact/node_face.hpp"
#include "contact/penalty.hpp"

namespace contactsim {

namespace {

/// Square root of two: from the radius of a square to its side.
constexpr double side_of_radius = 1.4142135623730951;

/// A node that stands beside a face by this share of its size is tied to it all the same.
constexpr double beside = 0.05;

double tolerance_of(const SurfacePair& pair, const FaceBound& face, double size_share) {
  const double automatic = size_share * side_of_radius * face.radius();
  return pair.capture_tolerance.value_or(pair.normal_tolerance.value_or(automatic));
}

bool is_tied(const ContactScene& scene, std::uint32_t surface, std::uint32_t other) {
  const std::uint32_t pair = scene.rules.find(surface, other);
  return pair != PairRules::none && scene.rules[pair].law == ContactLaw::tied && scene.rules[pair].is_active;
}

void set_nodes(const std::array<std::uint32_t, 4>& first, const std::array<std::uint32_t, 4>& second,
               Tie& tie) {
  std::copy(first.begin(), first.end(), tie.nodes.begin());
  std::copy(second.begin(), second.end(), tie.nodes.begin() + 4);
}

/// Where a node stands over a face; nothing when it does not.
std::optional<FacePoint> find_foot(const ContactScene& scene, std::uint32_t row, std::uint32_t face,
                                   double tolerance) {
  const MovingFace moving = scene.surface.face(face);
  const std::uint32_t node = scene.surface.faces().surface_nodes[row].node;
  const auto point = project_onto_face(moving.x, moving.is_triangle, scene.surface.x(node));
  if (!point || std::abs(point->gap) > tolerance) return std::nullopt;
  if (point->beyond > beside * scene.surface.bound(face).radius()) return std::nullopt;
  return point;
}

}  // namespace

std::optional<Tie> make_face_tie(const ContactScene& scene, std::uint32_t first, std::uint32_t second,
                                 double tolerance) {
  const ContactFace &a = scene.surface.faces().faces[first], &b = scene.surface.faces().faces[second];
  Tie tie;
  tie.pair = scene.rules.find(a.surface, b.surface);
  const SurfacePair& pair = *scene.rules[tie.pair].pair;
  tie.is_swapped = a.surface != pair.first;
  tie.first_place = first;
  tie.second_place = second;
  set_nodes(a.corners, b.corners, tie);
  const double stiffness = make_pair_penalty(a.backing, &b.backing, pair).stiffness;
  if (!tie_faces(scene.surface.face(first), scene.surface.face(second), stiffness, tolerance, tie))
    return std::nullopt;
  return tie;
}

std::optional<Tie> make_node_tie(const ContactScene& scene, std::uint32_t row, std::uint32_t face,
                                 double tolerance) {
  const auto point = find_foot(scene, row, face, tolerance);
  if (!point) return std::nullopt;
  const SurfaceNode& node = scene.surface.faces().surface_nodes[row];
  const ContactFace& other = scene.surface.faces().faces[face];
  const MovingFace moving = scene.surface.face(face);
  const Eigen::Vector3d x = scene.surface.x(node.node);
  Tie tie;
  tie.is_node = true;
  tie.pair = scene.rules.find(node.surface, other.surface);
  const SurfacePair& pair = *scene.rules[tie.pair].pair;
  tie.is_swapped = node.surface != pair.first;
  tie.first_place = row;
  tie.second_place = face;
  set_nodes({node.node, node.node, node.node, node.node}, other.corners, tie);
  tie.area = pair.node_share() * scene.surface.area_against(node, point->normal);
  const double stiffness = make_pair_penalty(node.backing, &other.backing, pair).stiffness * tie.area;
  tie_node(x, moving, corner_weights(point->xi, point->eta, moving.is_triangle), stiffness, tie);
  return tie;
}

std::vector<Tie> make_ties(const ContactScene& scene, const PairLists& face_partners,
                           const PairLists& node_faces, double size_share) {
  const ContactFaces& faces = scene.surface.faces();
  std::vector<Tie> ties;
  for (std::uint32_t first = 0; first < face_partners.n_rows(); ++first) {
    for (const std::uint32_t second : face_partners.of(first)) {
      if (!is_tied(scene, faces.faces[first].surface, faces.faces[second].surface)) continue;
      const SurfacePair& pair =
          *scene.rules[scene.rules.find(faces.faces[first].surface, faces.faces[second].surface)].pair;
      const double tolerance = tolerance_of(pair, scene.surface.bound(first), size_share);
      if (auto tie = make_face_tie(scene, first, second, tolerance)) ties.push_back(*tie);
    }
  }
  for (std::uint32_t row = 0; row < node_faces.n_rows(); ++row) {
    std::optional<double> nearest;
    std::uint32_t best = 0;
    double best_tolerance = 0.0;
    for (const std::uint32_t face : node_faces.of(row)) {
      if (!is_tied(scene, faces.surface_nodes[row].surface, faces.faces[face].surface)) continue;
      const SurfacePair& pair =
          *scene.rules[scene.rules.find(faces.surface_nodes[row].surface, faces.faces[face].surface)].pair;
      const double tolerance = tolerance_of(pair, scene.surface.bound(face), size_share);
      const auto foot = find_foot(scene, row, face, tolerance);
      if (!foot) continue;
      const double distance = std::abs(foot->gap) + foot->beyond;
      if (nearest && distance >= *nearest) continue;
      nearest = distance;
      best = face;
      best_tolerance = tolerance;
    }
    if (!nearest) continue;
    if (auto tie = make_node_tie(scene, row, best, best_tolerance)) ties.push_back(*tie);
  }
  return ties;
}

}  // namespace contactsim

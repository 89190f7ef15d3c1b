// SPDX-License-Identifier: BSD-3-Clause
#include "contact/make_ties.hpp"

#include <algorithm>
#include <cmath>

#include "contact/common_plane.hpp"
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

/// Whether a node stands over some face of a surface.
bool stands_over(const ContactScene& scene, const PairLists& node_faces, std::uint32_t row,
                 std::uint32_t surface, double tolerance) {
  return std::ranges::any_of(node_faces.of(row), [&](std::uint32_t face) {
    return scene.surface.faces().faces[face].surface == surface &&
           find_foot(scene, row, face, tolerance).has_value();
  });
}

}  // namespace

double share_of_node(const ContactScene& scene, const PairLists& node_faces, const NearPlace& place,
                     const Eigen::Vector4d& weights) {
  if (scene.rules[place.pair].pair->is_one_sided) return 1.0;
  const ContactFaces& faces = scene.surface.faces();
  const ContactFace& face = faces.faces[place.second];
  const std::uint32_t own = faces.surface_nodes[place.first].surface;
  double covered = 0.0;
  for (std::size_t k = 0; k < (face.is_triangle() ? 3u : 4u); ++k) {
    const auto row = faces.find_row(face.corners[k], face.surface);
    if (row && stands_over(scene, node_faces, *row, own, place.tolerance))
      covered += weights[static_cast<Eigen::Index>(k)];
  }
  return 1.0 - 0.5 * std::clamp(covered, 0.0, 1.0);
}

std::optional<FacePoint> find_foot(const ContactScene& scene, std::uint32_t row, std::uint32_t face,
                                   double tolerance) {
  const MovingFace moving = scene.surface.face(face);
  const SurfaceNode& node = scene.surface.faces().surface_nodes[row];
  auto point = project_onto_face(moving.x, moving.is_triangle, scene.surface.x(node.node));
  if (!point) return std::nullopt;
  point->gap -= node.radius;
  if (std::abs(point->gap) > tolerance) return std::nullopt;
  if (point->beyond > beside * scene.surface.bound(face).radius()) return std::nullopt;
  return point;
}

HeldPlace place_of_faces(const ContactScene& scene, std::uint32_t first, std::uint32_t second) {
  const ContactFace &a = scene.surface.faces().faces[first], &b = scene.surface.faces().faces[second];
  HeldPlace place;
  place.pair = scene.rules.find(a.surface, b.surface);
  place.is_swapped = a.surface != scene.rules[place.pair].pair->first;
  place.first_place = first;
  place.second_place = second;
  std::copy(a.corners.begin(), a.corners.end(), place.nodes.begin());
  std::copy(b.corners.begin(), b.corners.end(), place.nodes.begin() + 4);
  return place;
}

HeldPlace place_of_node(const ContactScene& scene, std::uint32_t row, std::uint32_t face) {
  const SurfaceNode& node = scene.surface.faces().surface_nodes[row];
  const ContactFace& other = scene.surface.faces().faces[face];
  HeldPlace place;
  place.is_node = true;
  place.pair = scene.rules.find(node.surface, other.surface);
  place.is_swapped = node.surface != scene.rules[place.pair].pair->first;
  place.first_place = row;
  place.second_place = face;
  std::fill_n(place.nodes.begin(), 4, node.node);
  std::copy(other.corners.begin(), other.corners.end(), place.nodes.begin() + 4);
  return place;
}

std::optional<Tie> make_face_tie(const ContactScene& scene, std::uint32_t first, std::uint32_t second,
                                 double tolerance) {
  const ContactFace &a = scene.surface.faces().faces[first], &b = scene.surface.faces().faces[second];
  Tie tie{place_of_faces(scene, first, second)};
  const double stiffness = make_pair_penalty(a.backing, &b.backing, *scene.rules[tie.pair].pair).stiffness;
  if (!tie_faces(scene.surface.face(first), scene.surface.face(second), stiffness, tolerance, tie))
    return std::nullopt;
  return tie;
}

std::optional<Tie> make_node_tie(const ContactScene& scene, const NearPlace& place) {
  const auto point = find_foot(scene, place.first, place.second, place.tolerance);
  if (!point) return std::nullopt;
  const SurfaceNode& node = scene.surface.faces().surface_nodes[place.first];
  const MovingFace moving = scene.surface.face(place.second);
  Tie tie{place_of_node(scene, place.first, place.second)};
  const SurfacePair& pair = *scene.rules[tie.pair].pair;
  tie.share = place.share;
  tie.area = place.share * scene.surface.area_against(node, point->normal);
  const Backing& other = scene.surface.faces().faces[place.second].backing;
  const double stiffness = make_pair_penalty(node.backing, &other, pair).stiffness * tie.area;
  tie_node(scene.surface.x(node.node), moving, corner_weights(point->xi, point->eta, moving.is_triangle),
           stiffness, tie);
  return tie;
}

namespace {

/// Whether one of a node's own faces is turned towards a normal. Nodes without faces look all round.
bool is_facing(const ContactScene& scene, const SurfaceNode& node, const Eigen::Vector3d& normal) {
  const ContactFaces& faces = scene.surface.faces();
  bool has_faces = false;
  for (const std::uint32_t own : faces.faces_of_node.of(node.node)) {
    if (faces.faces[own].surface != node.surface) continue;
    const Eigen::Vector3d area = scene.surface.area(faces.faces[own]);
    if (area.dot(normal) < most_aside * area.norm()) return true;
    has_faces = true;
  }
  return !has_faces;
}

/// The nearest of the faces that a node stands over and is held to; one that looks at the node's own faces
/// before all others. On the rim of a joint the sides of the other body are as near as what the joint joins.
std::optional<NearPlace> find_nearest(const ContactScene& scene, const PairLists& node_faces,
                                      std::uint32_t row, double size_share, const HoldsPlace& holds) {
  const ContactFaces& faces = scene.surface.faces();
  std::optional<NearPlace> best;
  Eigen::Vector4d weights;
  double nearest = std::numeric_limits<double>::infinity();
  bool faces_best = false;
  for (const std::uint32_t face : node_faces.of(row)) {
    const std::uint32_t pair = scene.rules.find(faces.surface_nodes[row].surface, faces.faces[face].surface);
    if (pair == PairRules::none || !scene.rules[pair].is_active || !holds(scene.rules.of_node(pair, row)))
      continue;
    const double tolerance = tolerance_of(*scene.rules[pair].pair, scene.surface.bound(face), size_share);
    const auto foot = find_foot(scene, row, face, tolerance);
    if (!foot) continue;
    const double distance = std::abs(foot->gap) + foot->beyond;
    const bool faces_node = is_facing(scene, faces.surface_nodes[row], foot->normal);
    if (faces_node == faces_best ? distance >= nearest : faces_best) continue;
    nearest = distance;
    faces_best = faces_node;
    best = {row, face, pair, true, tolerance};
    weights = corner_weights(foot->xi, foot->eta, faces.faces[face].is_triangle());
  }
  if (best) best->share = share_of_node(scene, node_faces, *best, weights);
  return best;
}

}  // namespace

std::vector<NearPlace> find_near_places(const ContactScene& scene, const PairLists& face_partners,
                                        const PairLists& node_faces, double size_share,
                                        const HoldsPlace& holds) {
  const ContactFaces& faces = scene.surface.faces();
  std::vector<NearPlace> places;
  for (std::uint32_t first = 0; first < face_partners.n_rows(); ++first) {
    for (const std::uint32_t second : face_partners.of(first)) {
      const std::uint32_t pair = scene.rules.find(faces.faces[first].surface, faces.faces[second].surface);
      if (pair == PairRules::none || !scene.rules[pair].is_active) continue;
      if (!holds(scene.rules.of_faces(pair, first, second))) continue;
      const double tolerance = tolerance_of(*scene.rules[pair].pair, scene.surface.bound(first), size_share);
      places.push_back({first, second, pair, false, tolerance});
    }
  }
  for (std::uint32_t row = 0; row < node_faces.n_rows(); ++row) {
    if (const auto nearest = find_nearest(scene, node_faces, row, size_share, holds))
      places.push_back(*nearest);
  }
  return places;
}

std::vector<Tie> make_ties(const ContactScene& scene, const PairLists& face_partners,
                           const PairLists& node_faces, double size_share, const HoldsPlace& holds) {
  std::vector<Tie> ties;
  for (const NearPlace& place : find_near_places(scene, face_partners, node_faces, size_share, holds)) {
    const auto tie = place.is_node ? make_node_tie(scene, place)
                                   : make_face_tie(scene, place.first, place.second, place.tolerance);
    if (tie) ties.push_back(*tie);
  }
  return ties;
}

}  // namespace contactsim

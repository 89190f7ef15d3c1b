// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap_places.hpp"

#include <algorithm>
#include <cmath>

#include "contact/node_face.hpp"
#include "contact/sharp_edges.hpp"

namespace contactsim {

namespace {

/// Overlap below this share of a face's size, or of a radius, is round-off.
constexpr double smallest_share = 1e-9;
/// A node in a valley between faces is over none of them, but beside them by less than this share of its
/// depth.
constexpr double beside_share = 0.25;

/// A surface looks against a face when the cosine of their normals is less; the corner of a cube against a
/// flat face has -0.58.
constexpr double against_cosine = -0.25;

/// Faces look at each other when the cosine of their normals is less; edges cross along the normals when that
/// of the normals with the way out is as far from 0.
constexpr double facing_cosine = -0.7;
/// Square of the sine of the angle below which edges do not cross but lie along each other.
constexpr double parallel = 0.03;
/// Nearer than this share to an end of an edge a place is at the end.
constexpr double at_end = 1e-6;

bool is_inside(double share) { return share > at_end && share < 1.0 - at_end; }

RecordSide side_of(const SurfaceNode& node) {
  RecordSide side;
  side.nodes.fill(node.node);
  side.weights = Eigen::Vector4d::UnitX();
  return side;
}

using EdgeNodes = std::array<std::uint32_t, 2>;

RecordSide side_of(const EdgeNodes& edge, double share) {
  return {{edge[0], edge[1], edge[1], edge[1]}, {1.0 - share, share, 0.0, 0.0}};
}

Segment segment_of(const MovingSurface& surface, const EdgeNodes& edge) {
  Segment segment;
  segment << surface.x(edge[0]), surface.x(edge[1]);
  return segment;
}

/// Calls visit(nodes) for each edge of a face.
template <class Visit>
void for_each_edge(const ContactFace& face, const Visit& visit) {
  const std::size_t n = face.is_triangle() ? 3 : 4;
  for (std::size_t k = 0; k < n; ++k) visit(EdgeNodes{face.corners[k], face.corners[(k + 1) % n]});
}

/// The place where two edges cross, the first deeper than the second along a normal; nothing where they do
/// not cross or miss each other.
///   outward  normal of the second edge's face [1]
std::optional<Overlap> find_crossing(const MovingSurface& surface, const EdgeNodes& first,
                                     const EdgeNodes& second, const Eigen::Vector3d& outward) {
  const Segment a = segment_of(surface, first), b = segment_of(surface, second);
  const Eigen::Vector3d p = a.col(1) - a.col(0), q = b.col(1) - b.col(0);
  Eigen::Vector3d normal = p.cross(q);
  const double square = normal.squaredNorm();
  if (!(square > parallel * p.squaredNorm() * q.squaredNorm())) return std::nullopt;
  normal *= (normal.dot(outward) < 0.0 ? -1.0 : 1.0) / std::sqrt(square);
  const EdgePlace place = nearest_points(a, b);
  if (!is_inside(place.s) || !is_inside(place.t) || normal.dot(outward) < -facing_cosine) return std::nullopt;
  const double depth = (b.col(0) + place.t * q - a.col(0) - place.s * p).dot(normal);
  return Overlap{side_of(first, place.s), side_of(second, place.t), depth, normal, depth, OverlapMover::both};
}

}  // namespace

void OverlapPlaces::visit_all(std::uint32_t pair, const Visit& visit) const {
  visit_nodes(pair, OverlapKind::meshed, visit);
  visit_nodes(pair, OverlapKind::lofted, visit);
  visit_edges(pair, visit);
  visit_rims(pair, visit);
}

void OverlapPlaces::visit_nodes(std::uint32_t index, OverlapKind kind, const Visit& visit) const {
  const SurfacePair& pair = model_.pairs[index];
  const bool is_lofted = kind == OverlapKind::lofted;
  const OverlapSites& sites = is_lofted ? sites_[index].lofted : sites_[index].meshed;
  const double left = is_lofted ? tolerance_ : 0.0;
  const std::span<const OverlapCandidate> faces = sites.faces;
  for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
    while (end < faces.size() && faces[end].place == faces[begin].place) ++end;
    const auto found = find_behind_faces(pair, faces.subspan(begin, end - begin));
    if (found && found->depth > left) visit(*found);
  }
  for (const OverlapCandidate& candidate : sites.planes) {
    const auto found = find_behind_plane(pair, candidate);
    if (found && found->depth > left) visit(*found);
  }
}

void OverlapPlaces::visit_edges(std::uint32_t pair, const Visit& visit) const {
  for (const OverlapCandidate& candidate : sites_[pair].edges) {
    const ContactEdge& first = parts_.faces.edges[candidate.place];
    const ContactEdge& second = parts_.faces.edges[candidate.partner];
    const EdgePlaces places(segment_of(points_.renewed(), first.nodes),
                            segment_of(points_.renewed(), second.nodes));
    for (const EdgePlace& place : places.get()) {
      const auto found = find_between(model_.pairs[pair], candidate, place);
      if (found && found->depth > tolerance_) visit(*found);
    }
  }
}

void OverlapPlaces::visit_rims(std::uint32_t pair, const Visit& visit) const {
  for (const OverlapCandidate& candidate : sites_[pair].rims) {
    const double reach =
        std::min(parts_.of_face[candidate.place].reach, parts_.of_face[candidate.partner].reach);
    visit_crossings(candidate, model_.pairs[pair].overlap_normal_tolerance.value_or(reach), visit);
  }
}

void OverlapPlaces::visit_crossings(const OverlapCandidate& faces, double deepest, const Visit& visit) const {
  const MovingSurface& surface = points_.renewed();
  const ContactFace& first = parts_.faces.faces[faces.place];
  const ContactFace& second = parts_.faces.faces[faces.partner];
  const Eigen::Vector3d outward_1 = surface.area(first).normalized();
  const Eigen::Vector3d outward_2 = surface.area(second).normalized();
  if (outward_1.dot(outward_2) > facing_cosine) return;
  for_each_edge(first, [&](const EdgeNodes& a) {
    for_each_edge(second, [&](const EdgeNodes& b) {
      const auto found = find_crossing(surface, a, b, outward_2);
      const double least = std::max(tolerance_, smallest_share * parts_.of_face[faces.partner].size);
      const bool is_in = found && found->depth > least && found->depth <= deepest;
      if (!is_in || found->normal.dot(outward_1) > facing_cosine) return;
      if (!joined_.are_joined(faces.place, faces.partner)) visit(*found);
    });
  });
}

std::optional<Overlap> OverlapPlaces::find_behind_faces(const SurfacePair& pair,
                                                        std::span<const OverlapCandidate> of_node) const {
  struct Near {
    std::uint32_t face = 0;
    Overlap overlap;
  };
  std::vector<Near> near;
  for (const OverlapCandidate& candidate : of_node) {
    if (const auto found = find_near_face(pair, candidate)) near.push_back({candidate.partner, *found});
  }
  // What is joined takes long to find out, and most nodes are in front of everything.
  if (std::ranges::none_of(near, [](const Near& one) { return one.overlap.depth > 0.0; }))
    return std::nullopt;
  const SurfaceNode& node = parts_.faces.surface_nodes[of_node.front().place];
  std::optional<Overlap> least;
  for (const Near& one : near) {
    if (least && !(one.overlap.distance < least->distance)) continue;
    if (!joined_.are_joined(node, one.face)) least = one.overlap;
  }
  return least && least->depth > 0.0 ? least : std::nullopt;
}

std::optional<Overlap> OverlapPlaces::find_near_face(const SurfacePair& pair,
                                                     const OverlapCandidate& candidate) const {
  const SurfaceNode& node = parts_.faces.surface_nodes[candidate.place];
  const ContactFace& face = parts_.faces.faces[candidate.partner];
  const OverlapNode& of_node = parts_.of_node[candidate.place];
  const OverlapFace& of_face = parts_.of_face[candidate.partner];
  const double radius = node.radius;
  const auto point = project_ball(points_.corners(face), face.is_triangle(), points_.at(node.node), radius);
  if (!point) return std::nullopt;
  const double least = smallest_share * of_face.size;
  const double depth = std::abs(point->gap) > least ? -point->gap : 0.0;
  // A ball whose middle is still in front of the face belongs there.
  const double deepest = pair.overlap_normal_tolerance.value_or(std::max(of_face.reach, radius));
  // Shells are thin beside the solids that they lie on.
  const bool is_lofted = parts_.is_lofted(node) || parts_.faces.is_lofted(face);
  const double valley = beside_share * (is_lofted ? std::min(depth, of_node.reach) : depth);
  const double beside = std::max({valley, least, pair.overlap_tangential_tolerance.value_or(0.0)});
  const bool is_near = std::abs(depth) <= deepest && point->beyond <= beside;
  if (!is_near || !looks_against(candidate.place, point->normal, is_lofted)) return std::nullopt;
  // On a face a node is outside, but one without a surface of its own may lie in the face's rim and go in
  // there.
  if (depth == 0.0 && of_node.size == 0.0 && radius == 0.0) return std::nullopt;
  const RecordSide at{face.corners, corner_weights(point->xi, point->eta, face.is_triangle())};
  return Overlap{side_of(node),
                 at,
                 depth,
                 point->normal,
                 std::abs(radius - depth),
                 radius > 0.0 ? OverlapMover::ball : OverlapMover::first};
}

bool OverlapPlaces::looks_against(std::uint32_t row, const Eigen::Vector3d& normal, bool is_lofted) const {
  const SurfaceNode& node = parts_.faces.surface_nodes[row];
  const OverlapNode& of_node = parts_.of_node[row];
  const bool has_faces = of_node.size > 0.0;
  if (!has_faces) return true;
  if (!is_lofted) return of_node.normal.dot(normal) < against_cosine * of_node.normal.norm();
  // The rim of a shell is too narrow to count in a mean.
  return std::ranges::any_of(parts_.faces.faces_of_node.of(node.node), [&](std::uint32_t index) {
    const ContactFace& face = parts_.faces.faces[index];
    const Eigen::Vector3d area = area_vector(points_.corners(face));
    return face.surface == node.surface && area.dot(normal) < against_cosine * area.norm();
  });
}

std::optional<Overlap> OverlapPlaces::find_behind_plane(const SurfacePair& pair,
                                                        const OverlapCandidate& candidate) const {
  const SurfaceNode& node = parts_.faces.surface_nodes[candidate.place];
  const OverlapNode& of_node = parts_.of_node[candidate.place];
  const AnalyticPlane& plane = model_.planes[candidate.partner];
  const Eigen::Vector3d normal = plane.normal.stableNormalized();
  const double radius = node.radius;
  const double depth = (plane.origin - points_.at(node.node)).dot(normal) + radius;
  const double deepest = pair.overlap_normal_tolerance.value_or(of_node.reach);
  const bool is_behind = depth > smallest_share * std::max(of_node.size, radius) && depth <= deepest;
  if (!is_behind || !looks_against(candidate.place, normal, parts_.is_lofted(node))) return std::nullopt;
  return Overlap{side_of(node), {}, depth, normal, depth, OverlapMover::first};
}

std::optional<Overlap> OverlapPlaces::find_between(const SurfacePair& pair, const OverlapCandidate& candidate,
                                                   const EdgePlace& place) const {
  const ContactEdge& first = parts_.faces.edges[candidate.place];
  const ContactEdge& second = parts_.faces.edges[candidate.partner];
  const double thicker = std::max(first.radius, second.radius);
  const auto found = find_edge_gap(points_.renewed(), first, second, place, thicker);
  if (!found) return std::nullopt;
  const double depth = -found->gap;
  const bool is_in = depth > smallest_share * thicker;
  if (!is_in || depth > pair.overlap_normal_tolerance.value_or(thicker)) return std::nullopt;
  return Overlap{side_of(first.nodes, place.s),
                 side_of(second.nodes, place.t),
                 depth,
                 found->normal,
                 depth,
                 OverlapMover::both};
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/overlap_detection.hpp"

#include <algorithm>
#include <cmath>

#include "contact/geometry/node_face.hpp"
#include "contact/mesh/feature_edges.hpp"

namespace contactsim {

namespace {

/// Overlap below this share of a face's size, or of a radius, is round-off.
constexpr double round_off_share = 1e-9;
/// A node in a valley between faces is over none of them, but beside them by less than this share of its
/// depth.
constexpr double beside_share = 0.25;

/// A surface faces a face when the cosine of their normals is less; the corner of a cube against a
/// flat face has -0.58.
constexpr double against_cosine = -0.25;
/// Square of the sine of the angle below which edges do not cross but lie along each other.
constexpr double parallel = 0.03;
/// Nearer than this share to an end of an edge a point is at the end.
constexpr double at_end = 1e-6;

bool is_inside(double share) { return share > at_end && share < 1.0 - at_end; }

ContactPointSide side_of(const SurfaceNode& node) {
  ContactPointSide side;
  side.nodes.fill(node.node);
  side.weights = Eigen::Vector4d::UnitX();
  return side;
}

using EdgeNodes = std::array<ContactNodeIndex, 2>;

ContactPointSide side_of(const EdgeNodes& edge, double share) {
  return {{edge[0], edge[1], edge[1], edge[1]}, {1.0 - share, share, 0.0, 0.0}};
}

Segment segment_of(const ContactKinematics& kinematics, const EdgeNodes& edge) {
  Segment segment;
  segment << kinematics.x(edge[0]), kinematics.x(edge[1]);
  return segment;
}

/// Calls visit(nodes) for each edge of a face.
template <class Visit>
void for_each_edge(const ContactFace& face, const Visit& visit) {
  const std::size_t n = face.is_triangle() ? 3 : 4;
  for (std::size_t k = 0; k < n; ++k) visit(EdgeNodes{face.corners[k], face.corners[(k + 1) % n]});
}

/// The point where two edges cross, the first deeper than the second along a normal; nothing where they do
/// not cross or miss each other.
///   outward  normal of the second edge's face [1]
std::optional<Overlap> find_crossing(const ContactKinematics& kinematics, const EdgeNodes& first,
                                     const EdgeNodes& second, const Eigen::Vector3d& outward) {
  const Segment a = segment_of(kinematics, first), b = segment_of(kinematics, second);
  const Eigen::Vector3d p = a.col(1) - a.col(0), q = b.col(1) - b.col(0);
  Eigen::Vector3d normal = p.cross(q);
  const double square = normal.squaredNorm();
  if (!(square > parallel * p.squaredNorm() * q.squaredNorm())) return std::nullopt;
  normal *= (normal.dot(outward) < 0.0 ? -1.0 : 1.0) / std::sqrt(square);
  const EdgePairPoint pair_point = nearest_points(a, b);
  if (!is_inside(pair_point.s) || !is_inside(pair_point.t) || normal.dot(outward) < -facing_cosine)
    return std::nullopt;
  const double depth = (b.col(0) + pair_point.t * q - a.col(0) - pair_point.s * p).dot(normal);
  return Overlap{
      side_of(first, pair_point.s), side_of(second, pair_point.t), depth, normal, depth, OverlapMover::both};
}

}  // namespace

void OverlapDetection::visit_all(PairIndex pair, const Visit& visit) const {
  visit_nodes(pair, OverlapKind::meshed, visit);
  visit_nodes(pair, OverlapKind::lofted, visit);
  visit_edges(pair, visit);
  visit_rims(pair, visit);
}

void OverlapDetection::visit_nodes(PairIndex index, OverlapKind kind, const Visit& visit) const {
  const SurfacePair& pair = model_.pairs[index];
  const bool is_lofted = kind == OverlapKind::lofted;
  const OverlapSites& sites = is_lofted ? sites_[index].lofted : sites_[index].meshed;
  const double left = is_lofted ? tolerance_ : 0.0;
  const std::span<const NodeFaceCandidate> faces = sites.faces;
  for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
    while (end < faces.size() && faces[end].entity == faces[begin].entity) ++end;
    const auto found = find_behind_faces(pair, faces.subspan(begin, end - begin));
    if (found && found->depth > left) visit(*found);
  }
  for (const NodePlaneCandidate& candidate : sites.planes) {
    const auto found = find_behind_plane(pair, candidate);
    if (found && found->depth > left) visit(*found);
  }
}

void OverlapDetection::visit_edges(PairIndex pair, const Visit& visit) const {
  for (const EdgePairCandidate& candidate : sites_[pair].edges) {
    const ContactEdge& first = parts_.contact_mesh.edges[candidate.entity];
    const ContactEdge& second = parts_.contact_mesh.edges[candidate.partner];
    const EdgePairPoints places(segment_of(points_.renewed(), first.nodes),
                                segment_of(points_.renewed(), second.nodes));
    for (const EdgePairPoint& pair_point : places.get()) {
      const auto found = find_between(model_.pairs[pair], candidate, pair_point);
      if (found && found->depth > tolerance_) visit(*found);
    }
  }
}

void OverlapDetection::visit_rims(PairIndex pair, const Visit& visit) const {
  for (const FacePairCandidate& candidate : sites_[pair].rims) {
    const double half_thickness = std::min(parts_.of_face[candidate.entity].half_thickness,
                                           parts_.of_face[candidate.partner].half_thickness);
    visit_crossings(candidate, model_.pairs[pair].overlap_normal_tolerance.value_or(half_thickness), visit);
  }
}

void OverlapDetection::visit_crossings(const FacePairCandidate& faces, double deepest,
                                       const Visit& visit) const {
  const ContactKinematics& kinematics = points_.renewed();
  const ContactFace& first = parts_.contact_mesh.faces[faces.entity];
  const ContactFace& second = parts_.contact_mesh.faces[faces.partner];
  const Eigen::Vector3d outward_1 = kinematics.area(first).normalized();
  const Eigen::Vector3d outward_2 = kinematics.area(second).normalized();
  if (outward_1.dot(outward_2) > facing_cosine) return;
  for_each_edge(first, [&](const EdgeNodes& a) {
    for_each_edge(second, [&](const EdgeNodes& b) {
      const auto found = find_crossing(kinematics, a, b, outward_2);
      const double least = std::max(tolerance_, round_off_share * parts_.of_face[faces.partner].size);
      const bool is_in = found && found->depth > least && found->depth <= deepest;
      if (!is_in || found->normal.dot(outward_1) > facing_cosine) return;
      if (!adjacent_.are_adjacent(faces.entity, faces.partner)) visit(*found);
    });
  });
}

std::optional<Overlap> OverlapDetection::find_behind_faces(const SurfacePair& pair,
                                                           std::span<const NodeFaceCandidate> of_node) const {
  std::vector<NearOverlap> near;
  for (const NodeFaceCandidate& candidate : of_node) {
    if (const auto found = find_near_face(pair, candidate)) near.push_back({candidate.partner, *found});
  }
  // What is joined takes long to find out, and most nodes are in front of everything.
  if (std::ranges::none_of(near, [](const NearOverlap& one) { return one.overlap.depth > 0.0; }))
    return std::nullopt;
  const auto least = nearest_of(of_node.front().entity, near);
  return least && least->depth > 0.0 ? least : std::nullopt;
}

std::optional<Overlap> OverlapDetection::find_before_faces(const SurfacePair& pair,
                                                           std::span<const NodeFaceCandidate> of_node,
                                                           double reach) const {
  std::vector<NearOverlap> near;
  for (const NodeFaceCandidate& candidate : of_node) {
    if (const auto found = find_near_face(pair, candidate, reach))
      near.push_back({candidate.partner, *found});
  }
  const auto least = nearest_of(of_node.front().entity, near);
  return least && least->depth < 0.0 ? least : std::nullopt;
}

std::optional<Overlap> OverlapDetection::nearest_of(SurfaceNodeIndex row,
                                                    std::span<const NearOverlap> near) const {
  const SurfaceNode& node = parts_.contact_mesh.surface_nodes[row];
  std::optional<Overlap> least;
  for (const NearOverlap& one : near) {
    if (least && !(one.overlap.distance < least->distance)) continue;
    if (!adjacent_.are_adjacent(node, one.face)) least = one.overlap;
  }
  return least;
}

std::optional<Overlap> OverlapDetection::find_near_face(const SurfacePair& pair,
                                                        const NodeFaceCandidate& candidate,
                                                        std::optional<double> reach) const {
  const SurfaceNode& node = parts_.contact_mesh.surface_nodes[candidate.entity];
  const ContactFace& face = parts_.contact_mesh.faces[candidate.partner];
  const OverlapNode& of_node = parts_.of_node[candidate.entity];
  const OverlapFace& of_face = parts_.of_face[candidate.partner];
  const double radius = node.radius;
  const SmoothFace* round = parts_.contact_mesh.smooth_faces.find(pair.smoothing, candidate.partner);
  const auto point =
      project_sphere(points_.corners(face), face.is_triangle(), round, points_.at(node.node), radius);
  if (!point) return std::nullopt;
  const double least = round_off_share * of_face.size;
  const double depth = std::abs(point->gap) > least ? -point->gap : 0.0;
  // A sphere whose middle is still in front of the face belongs there.
  const double deepest =
      reach ? *reach + least
            : pair.overlap_normal_tolerance.value_or(std::max(of_face.half_thickness, radius));
  // Shells are thin beside the solids that they lie on.
  const bool is_lofted = parts_.is_lofted(node) || parts_.contact_mesh.is_lofted(face);
  const double valley = beside_share * (is_lofted ? std::min(depth, of_node.half_thickness) : depth);
  const double beside = std::max({valley, least, pair.overlap_tangential_tolerance.value_or(0.0)});
  const bool is_near = std::abs(depth) <= deepest && point->beyond <= beside;
  if (!is_near || !is_facing(candidate.entity, point->normal, is_lofted)) return std::nullopt;
  // On a face a node is outside, but one without a surface of its own may lie in the face's rim and go in
  // there.
  if (depth == 0.0 && of_node.size == 0.0 && radius == 0.0) return std::nullopt;
  const ContactPointSide at{face.corners, corner_weights(point->xi, point->eta, face.is_triangle())};
  return Overlap{side_of(node),
                 at,
                 depth,
                 point->normal,
                 std::abs(radius - depth),
                 radius > 0.0 ? OverlapMover::ball : OverlapMover::first};
}

bool OverlapDetection::is_facing(SurfaceNodeIndex row, const Eigen::Vector3d& normal, bool is_lofted) const {
  const SurfaceNode& node = parts_.contact_mesh.surface_nodes[row];
  const OverlapNode& of_node = parts_.of_node[row];
  const bool has_faces = of_node.size > 0.0;
  if (!has_faces) return true;
  if (!is_lofted) return of_node.normal.dot(normal) < against_cosine * of_node.normal.norm();
  // The rim of a shell is too narrow to count in a mean.
  return std::ranges::any_of(parts_.contact_mesh.faces_of_node.of(node.node), [&](FaceIndex index) {
    const ContactFace& face = parts_.contact_mesh.faces[index];
    const Eigen::Vector3d area = area_vector(points_.corners(face));
    return face.surface == node.surface && area.dot(normal) < against_cosine * area.norm();
  });
}

std::optional<Overlap> OverlapDetection::find_behind_plane(const SurfacePair& pair,
                                                           const NodePlaneCandidate& candidate) const {
  const SurfaceNode& node = parts_.contact_mesh.surface_nodes[candidate.entity];
  const OverlapNode& of_node = parts_.of_node[candidate.entity];
  const AnalyticPlane& plane = model_.planes[candidate.partner];
  const Eigen::Vector3d normal = plane.normal.stableNormalized();
  const double radius = node.radius;
  const double depth = (plane.origin - points_.at(node.node)).dot(normal) + radius;
  const double deepest = pair.overlap_normal_tolerance.value_or(of_node.half_thickness);
  const bool is_behind = depth > round_off_share * std::max(of_node.size, radius) && depth <= deepest;
  if (!is_behind || !is_facing(candidate.entity, normal, parts_.is_lofted(node))) return std::nullopt;
  return Overlap{side_of(node), {}, depth, normal, depth, OverlapMover::first};
}

std::optional<Overlap> OverlapDetection::find_before_plane(const NodePlaneCandidate& candidate,
                                                           double reach) const {
  const SurfaceNode& node = parts_.contact_mesh.surface_nodes[candidate.entity];
  const double size = std::max<double>(parts_.of_node[candidate.entity].size, node.radius);
  const AnalyticPlane& plane = model_.planes[candidate.partner];
  const Eigen::Vector3d normal = plane.normal.stableNormalized();
  const double gap = (points_.at(node.node) - plane.origin).dot(normal) - node.radius;
  const bool is_near = gap > round_off_share * size && gap <= reach + round_off_share * size;
  if (!is_near || !is_facing(candidate.entity, normal, parts_.is_lofted(node))) return std::nullopt;
  return Overlap{side_of(node), {}, -gap, normal, gap, OverlapMover::first};
}

std::optional<Overlap> OverlapDetection::find_between(const SurfacePair& pair,
                                                      const EdgePairCandidate& candidate,
                                                      const EdgePairPoint& pair_point) const {
  const ContactEdge& first = parts_.contact_mesh.edges[candidate.entity];
  const ContactEdge& second = parts_.contact_mesh.edges[candidate.partner];
  const double thicker = std::max(first.radius, second.radius);
  const auto found = find_edge_gap(points_.renewed(), first, second, pair_point, thicker);
  if (!found) return std::nullopt;
  const double depth = -found->gap;
  const bool is_in = depth > round_off_share * thicker;
  if (!is_in || depth > pair.overlap_normal_tolerance.value_or(thicker)) return std::nullopt;
  return Overlap{side_of(first.nodes, pair_point.s),
                 side_of(second.nodes, pair_point.t),
                 depth,
                 found->normal,
                 depth,
                 OverlapMover::both};
}

}  // namespace contactsim

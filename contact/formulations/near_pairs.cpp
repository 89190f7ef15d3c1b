// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/near_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "contact/formulations/covered_share.hpp"
#include "contact/geometry/common_plane.hpp"
#include "contact/geometry/node_face.hpp"

namespace contactsim {

namespace {

/// Square root of two: from the radius of a square to its side.
constexpr double side_of_radius = 1.4142135623730951;

/// A node that stands beside a face by this share of its size is tied to it all the same.
constexpr double beside = 0.05;

/// Whether a node of a face projects inside some face of a surface along that face. The sides of a body that
/// stands on it are none of those.
bool projects_inside(const ContactStepContext& context, const NodeFaceLists& node_faces, SurfaceNodeIndex row,
                     FaceIndex of, SurfaceIndex surface, double tolerance) {
  const ContactMesh& contact_mesh = context.kinematics.contact_mesh();
  const Eigen::Vector3d normal = context.kinematics.area(contact_mesh.faces[of]).normalized();
  return std::ranges::any_of(node_faces.of(row), [&](FaceIndex face) {
    if (contact_mesh.faces[face].surface != surface) return false;
    const Eigen::Vector3d area = context.kinematics.area(contact_mesh.faces[face]);
    return std::abs(area.dot(normal)) > -max_facing_cosine * area.norm() &&
           find_closest_point(context, row, face, tolerance).has_value();
  });
}

}  // namespace

double capture_tolerance_of(const SurfacePair& pair, const FaceBound& face, double size_share) {
  const double automatic = size_share * side_of_radius * face.radius();
  return pair.capture_tolerance.value_or(pair.normal_tolerance.value_or(automatic));
}

bool is_facing(const ContactKinematics& kinematics, const SurfaceNode& node, const Eigen::Vector3d& normal) {
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  bool has_faces = false;
  for (const FaceIndex own : contact_mesh.faces_of_node.of(node.node)) {
    if (contact_mesh.faces[own].surface != node.surface) continue;
    const Eigen::Vector3d area = kinematics.area(contact_mesh.faces[own]);
    if (area.dot(normal) < facing_limit(contact_mesh.faces[own].sharpness) * area.norm()) return true;
    has_faces = true;
  }
  return !has_faces;
}

double share_of_node(const ContactStepContext& context, const NodeFaceLists& node_faces,
                     const NearPair& near_pair, const Eigen::Vector4d& weights) {
  if (context.rules[near_pair.pair].pair->is_one_sided) return 1.0;
  const ContactMesh& contact_mesh = context.kinematics.contact_mesh();
  const ContactFace& face = contact_mesh.faces[near_pair.second];
  const SurfaceIndex own = contact_mesh.surface_nodes[near_pair.row()].surface;
  double covered = 0.0;
  for (std::size_t k = 0; k < (face.is_triangle() ? 3u : 4u); ++k) {
    const auto row = contact_mesh.find_row(face.corners[k], face.surface);
    if (row && projects_inside(context, node_faces, *row, near_pair.second, own, near_pair.tolerance))
      covered += weights[static_cast<Eigen::Index>(k)];
  }
  const SurfaceNode& node = contact_mesh.surface_nodes[near_pair.row()];
  return covered_share(context.kinematics, node, near_pair.second) *
         (1.0 - 0.5 * std::clamp(covered, 0.0, 1.0));
}

std::optional<ClosestPoint> find_closest_point(const ContactStepContext& context, SurfaceNodeIndex row,
                                               FaceIndex face, double tolerance) {
  const MovingFace moving = context.kinematics.face(face);
  const SurfaceNode& node = context.kinematics.contact_mesh().surface_nodes[row];
  auto point = project_onto_face(moving.x, moving.is_triangle, context.kinematics.x(node.node));
  if (!point) return std::nullopt;
  point->gap -= node.radius;
  if (std::abs(point->gap) > tolerance) return std::nullopt;
  if (point->beyond > beside * context.kinematics.bound(face).radius()) return std::nullopt;
  return point;
}

InterfaceConstraint constraint_of_faces(const ContactStepContext& context, FaceIndex first,
                                        FaceIndex second) {
  const ContactFace &a = context.kinematics.contact_mesh().faces[first],
                    &b = context.kinematics.contact_mesh().faces[second];
  InterfaceConstraint constraint;
  constraint.pair = *context.rules.find(a.surface, b.surface);
  constraint.is_swapped = a.surface != context.rules[constraint.pair].pair->first;
  constraint.first_entity = first.value;
  constraint.second = second;
  std::copy(a.corners.begin(), a.corners.end(), constraint.nodes.begin());
  std::copy(b.corners.begin(), b.corners.end(), constraint.nodes.begin() + 4);
  return constraint;
}

InterfaceConstraint constraint_of_node(const ContactStepContext& context, SurfaceNodeIndex row,
                                       FaceIndex face) {
  const SurfaceNode& node = context.kinematics.contact_mesh().surface_nodes[row];
  const ContactFace& other = context.kinematics.contact_mesh().faces[face];
  InterfaceConstraint constraint;
  constraint.is_node = true;
  constraint.pair = *context.rules.find(node.surface, other.surface);
  constraint.is_swapped = node.surface != context.rules[constraint.pair].pair->first;
  constraint.first_entity = row.value;
  constraint.second = face;
  std::fill_n(constraint.nodes.begin(), 4, node.node);
  std::copy(other.corners.begin(), other.corners.end(), constraint.nodes.begin() + 4);
  return constraint;
}

namespace {

/// The nearest of the faces that a node projects inside and is held to; one that faces the node's own
/// faces before all others. On the rim of a joint the sides of the other body are as near as what the joint
/// joins.
std::optional<NearPair> find_nearest(const ContactStepContext& context, const NodeFaceLists& node_faces,
                                     SurfaceNodeIndex row, double size_share, const HoldsPair& holds) {
  const ContactMesh& contact_mesh = context.kinematics.contact_mesh();
  std::optional<NearPair> best;
  Eigen::Vector4d weights;
  double nearest = std::numeric_limits<double>::infinity();
  bool faces_best = false;
  for (const FaceIndex face : node_faces.of(row)) {
    const OptionalIndex<PairIndex> found =
        context.rules.find(contact_mesh.surface_nodes[row].surface, contact_mesh.faces[face].surface);
    if (!found) continue;
    const PairIndex pair = *found;
    if (!context.rules[pair].is_active || !holds(context.rules.of_node(pair, row))) continue;
    const double tolerance =
        capture_tolerance_of(*context.rules[pair].pair, context.kinematics.bound(face), size_share);
    const auto closest = find_closest_point(context, row, face, tolerance);
    if (!closest) continue;
    const double distance = std::abs(closest->gap) + closest->beyond;
    const bool faces_node = is_facing(context.kinematics, contact_mesh.surface_nodes[row], closest->normal);
    if (faces_node == faces_best ? distance >= nearest : faces_best) continue;
    nearest = distance;
    faces_best = faces_node;
    best = {row.value, face, pair, true, tolerance};
    best->is_facing = faces_node;
    weights = corner_weights(closest->xi, closest->eta, contact_mesh.faces[face].is_triangle());
  }
  if (best) best->share = share_of_node(context, node_faces, *best, weights);
  return best;
}

}  // namespace

std::vector<NearPair> find_near_pairs(const ContactStepContext& context, const FacePairLists& face_partners,
                                      const NodeFaceLists& node_faces, double size_share,
                                      const HoldsPair& holds) {
  const ContactMesh& contact_mesh = context.kinematics.contact_mesh();
  std::vector<NearPair> near_pairs;
  for (const FaceIndex first : face_partners.rows()) {
    for (const FaceIndex second : face_partners.of(first)) {
      const OptionalIndex<PairIndex> found =
          context.rules.find(contact_mesh.faces[first].surface, contact_mesh.faces[second].surface);
      if (!found || !context.rules[*found].is_active) continue;
      const PairIndex pair = *found;
      if (!holds(context.rules.of_faces(pair, first, second))) continue;
      const double tolerance =
          capture_tolerance_of(*context.rules[pair].pair, context.kinematics.bound(first), size_share);
      near_pairs.push_back({first.value, second, pair, false, tolerance});
    }
  }
  for (const SurfaceNodeIndex row : node_faces.rows()) {
    if (const auto nearest = find_nearest(context, node_faces, row, size_share, holds))
      near_pairs.push_back(*nearest);
  }
  return near_pairs;
}

std::optional<MeanOverlap> find_mean_overlap(const MovingFace& first, const MovingFace& second,
                                             double tolerance) {
  const auto found = find_face_face_points(first, second);
  if (!found) return std::nullopt;
  MeanOverlap mean;
  found->visit_near(tolerance, [&mean](double area, double, const Eigen::Vector4d& weights_1,
                                       const Eigen::Vector4d& weights_2) {
    mean.weights_1 += area * weights_1;
    mean.weights_2 += area * weights_2;
    mean.area += area;
  });
  if (mean.area == 0.0) return std::nullopt;
  mean.weights_1 /= mean.area;
  mean.weights_2 /= mean.area;
  return mean;
}

}  // namespace contactsim

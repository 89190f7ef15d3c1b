// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/flush_rims.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "contact/geometry/common_plane.hpp"

namespace contactsim {

namespace {

/// Faces whose normals have a smaller cosine have a rim between them.
constexpr double sharpest_smooth = 0.7;

/// A face whose surroundings turn by less at the start has no rim, though it may bend somewhat [degrees].
constexpr float min_rim = 35.0f;

/// A strip may be this much wider than the penetration of the face beyond the rim was deep: rims may be
/// deeper than the face's middle, and what carries a body gives way by some layers of elements where the next
/// part, which carries nothing, does not. A penalty or a step is as soft as three layers.
constexpr double over_depth = 4.0;

/// Faces are flush though they miss each other by this share of half a side face's height, once the face
/// beyond the rim touches.
constexpr double just_flush = 1e-2;

/// Side faces inside a joint face each other, askew by some 50 degrees at most, as a cosine.
constexpr float max_skew = -0.65f;

/// What lies before a side face, as seen from its rims.
struct Ahead {
  Eigen::Vector3d closing;                    ///< velocity of the side face relative to it [length/time]
  Eigen::Vector3d normal;                     ///< of the other side there [1]
  std::span<const Eigen::Vector3d> points;    ///< [length]
  double share = 1.0;                         ///< of the strip's width that they may lie behind the rim [1]
  std::span<const ContactNodeIndex> corners;  ///< contact nodes of the other side's entity
  SurfaceIndex surface;                       ///< of the other side
};

/// Whether some face at the corners of what lies ahead is facing a direction, and turns away from what
/// lies ahead: only where the faces beyond both rims lie flat on each other does a side face rise by so
/// little that it is none. A sheet that is bent over the rim turns towards it.
bool has_opposite(const ContactStepContext& context, const Ahead& ahead, const Eigen::Vector3d& out) {
  constexpr double opposite = -0.9;
  const ContactMesh& contact_mesh = context.kinematics.contact_mesh();
  return std::ranges::any_of(ahead.corners, [&](ContactNodeIndex corner) {
    const Eigen::Vector3d x = context.kinematics.x(corner);
    return std::ranges::any_of(contact_mesh.faces_of_node.of(corner), [&](FaceIndex face) {
      const FaceBound& bound = context.kinematics.bound(face);
      return contact_mesh.faces[face].surface == ahead.surface &&
             bound.normal().cast<double>().dot(out) < opposite &&
             (context.kinematics.face_corners(face).rowwise().mean() - x).dot(ahead.normal) <= 0.0;
    });
  });
}

/// Whether a face lies in a surface with one of this normal, without a root: most do. Says no where it is
/// close.
bool is_surely_smooth(const Eigen::Vector3d& area, const Eigen::Vector3d& normal) {
  constexpr double more = 1.0 + 1e-9;
  const double along = area.dot(normal);
  return along > 0.0 && along * along > more * sharpest_smooth * sharpest_smooth * area.squaredNorm();
}

/// Whether all points lie in the strip of a side face below one of its rims.
bool lie_in_strip(const ContactStepContext& context, FaceIndex face, const Ahead& ahead) {
  const ContactMesh& contact_mesh = context.kinematics.contact_mesh();
  const ContactFace& side = contact_mesh.faces[face];
  if (side.sharpness < min_rim || context.depths == nullptr) return false;
  // Found where a face beyond a rim has touched something, which few have.
  std::optional<FaceCorners> corners;
  Eigen::Vector3d normal, centre;
  const auto place_side = [&] {
    if (corners) return;
    corners = context.kinematics.face_corners(face);
    normal = area_vector(*corners).normalized();
    centre = 0.25 * (corners->col(0) + corners->col(1) + corners->col(2) + corners->col(3));
  };
  for (const ContactNodeIndex corner : side.corners) {
    if (!context.depths->has_touched_at(corner)) continue;
    for (const FaceIndex beyond : contact_mesh.faces_of_node.of(corner)) {
      const double touched = flush_width(context, beyond);
      if (!(touched > 0.0)) continue;
      if (contact_mesh.faces[beyond].surface != side.surface || beyond == face) continue;
      place_side();
      const Eigen::Vector3d x = context.kinematics.x(corner);
      const Eigen::Vector3d area = context.kinematics.area(contact_mesh.faces[beyond]);
      if (is_surely_smooth(area, normal)) continue;
      const Eigen::Vector3d out = area.normalized();
      const double height = (x - centre).dot(out);
      if (out.dot(normal) > sharpest_smooth || !(height > 0.0)) continue;
      if (out.dot(ahead.normal) < max_skew) continue;  // it is the face beyond that stands on what lies ahead
      const double closed = std::max(0.0, ahead.closing.dot(out)) * context.dt;
      const double width = std::min(touched + just_flush * height + closed, height) * ahead.share;
      const auto is_in_strip = [&](const auto& point) { return (x - point).dot(out) <= width; };
      if (std::ranges::all_of(ahead.points, is_in_strip) && has_opposite(context, ahead, out)) return true;
    }
  }
  return false;
}

}  // namespace

double flush_width(const ContactStepContext& context, FaceIndex face) {
  return context.depths != nullptr ? over_depth * context.depths->of(face) : 0.0;
}

bool is_at_flush_rim(const ContactStepContext& context, FaceIndex first, FaceIndex second,
                     const FaceFaceContact& contact) {
  const ContactFace &a_face = context.kinematics.contact_mesh().faces[first],
                    &b_face = context.kinematics.contact_mesh().faces[second];
  if (a_face.sharpness < min_rim && b_face.sharpness < min_rim) return false;
  const FaceBound &a = context.kinematics.bound(first), &b = context.kinematics.bound(second);
  // Only slivers: a square has twice the area of its radius squared.
  const double radius = std::min(a.radius(), b.radius());
  if (contact.area > radius * radius) return false;
  if (a.normal().dot(b.normal()) > max_skew) return false;
  const Eigen::Vector3d centre = context.kinematics.face(first).x * contact.weights_1;
  const Eigen::Vector3d closing = (a.velocity() - b.velocity()).cast<double>();
  constexpr double centre_of_strip = 0.5;
  return lie_in_strip(context, first,
                      {closing,
                       b.normal().cast<double>(),
                       {&centre, 1},
                       centre_of_strip,
                       b_face.corners,
                       b_face.surface}) ||
         lie_in_strip(context, second,
                      {-closing,
                       a.normal().cast<double>(),
                       {&centre, 1},
                       centre_of_strip,
                       a_face.corners,
                       a_face.surface});
}

bool is_at_flush_rim(const ContactStepContext& context, SurfaceNodeIndex row, FaceIndex face,
                     const Eigen::Vector3d& normal) {
  const ContactMesh& contact_mesh = context.kinematics.contact_mesh();
  const SurfaceNode& node = contact_mesh.surface_nodes[row];
  const auto has_rim = [&](FaceIndex index) { return contact_mesh.faces[index].sharpness >= min_rim; };
  if (!has_rim(face) && std::ranges::none_of(contact_mesh.faces_of_node.of(node.node), has_rim)) return false;
  const Eigen::Vector3d closing =
      context.kinematics.v(node.node) - context.kinematics.bound(face).velocity().cast<double>();
  const FaceCorners other = context.kinematics.face(face).x;
  const std::array<Eigen::Vector3d, 4> corners{other.col(0), other.col(1), other.col(2), other.col(3)};
  std::vector<Eigen::Vector3d> own_points;
  for (const FaceIndex own : contact_mesh.faces_of_node.of(node.node)) {
    if (contact_mesh.faces[own].surface != node.surface) continue;
    if (!(context.kinematics.bound(own).normal().cast<double>().dot(normal) < max_skew)) continue;
    const ContactFace& opposed = contact_mesh.faces[face];
    if (lie_in_strip(context, own, {closing, normal, corners, 1.0, opposed.corners, opposed.surface}))
      return true;
    for (const ContactNodeIndex corner : contact_mesh.faces[own].corners)
      own_points.push_back(context.kinematics.x(corner));
  }
  if (own_points.empty()) own_points.push_back(context.kinematics.x(node.node));
  return lie_in_strip(context, face, {-closing, -normal, own_points, 1.0, {&node.node, 1}, node.surface});
}

}  // namespace contactsim

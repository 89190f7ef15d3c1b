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
  double share = 1.0;                         ///< of a strip's width that it may lie behind the rim [1]
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
      if (contact_mesh.faces[face].surface != ahead.surface) return false;
      const FaceCorners corners = context.kinematics.face_corners(face);
      const Eigen::Vector3d area = area_vector(corners);
      return area.dot(out) < opposite * area.norm() &&
             (corners.rowwise().mean() - x).dot(ahead.normal) <= 0.0;
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

/// Calls visit(strip) for the strips of a side face below its rims until that returns true; returns whether
/// it did.
template <class Visit>
bool visit_strips(const ContactStepContext& context, FaceIndex face, const Ahead& ahead, const Visit& visit) {
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
      if (visit(FlushStrip{x, out, width})) return true;
    }
  }
  return false;
}

/// A face that lies before a side face; how they close is left.
Ahead ahead_of(const ContactStepContext& context, FaceIndex face) {
  constexpr double centre_of_strip = 0.5;
  const ContactFace& other = context.kinematics.contact_mesh().faces[face];
  return {Eigen::Vector3d::Zero(), context.kinematics.bound(face).normal().cast<double>(), centre_of_strip,
          other.corners, other.surface};
}

/// Whether all points lie in the strip of a side face below one of its rims.
bool lie_in_strip(const ContactStepContext& context, FaceIndex face, const Ahead& ahead,
                  std::span<const Eigen::Vector3d> points) {
  return visit_strips(context, face, ahead, [&](const FlushStrip& strip) {
    return std::ranges::all_of(points, [&](const auto& point) { return strip.holds(point); }) &&
           has_opposite(context, ahead, strip.out);
  });
}

}  // namespace

double flush_width(const ContactStepContext& context, FaceIndex face) {
  return context.depths != nullptr ? over_depth * context.depths->of(face) : 0.0;
}

bool FlushStrips::hold(const FaceFaceContact& contact) {
  const auto& faces = context_.kinematics.contact_mesh().faces;
  if (faces[first_].sharpness < min_rim && faces[second_].sharpness < min_rim) return false;
  const FaceBound &a = context_.kinematics.bound(first_), &b = context_.kinematics.bound(second_);
  // Only slivers: a square has twice the area of its radius squared.
  const double radius = std::min(a.radius(), b.radius());
  if (contact.area > radius * radius) return false;
  if (a.normal().dot(b.normal()) > max_skew) return false;
  if (!are_found_) find();
  const Eigen::Vector3d centre = context_.kinematics.face_corners(first_) * contact.weights_1;
  return std::ranges::any_of(strips_, [&](const Strip& strip) {
    return strip.holds(centre) && has_opposite(context_, ahead_of(context_, strip.other), strip.out);
  });
}

void FlushStrips::find() {
  are_found_ = true;
  const auto velocity = [&](FaceIndex face) { return context_.kinematics.bound(face).velocity(); };
  const auto add_strips = [&](FaceIndex side, FaceIndex other) {
    Ahead ahead = ahead_of(context_, other);
    ahead.closing = (velocity(side) - velocity(other)).cast<double>();
    visit_strips(context_, side, ahead, [&](const FlushStrip& strip) {
      strips_.push_back({strip, other});
      return false;
    });
  };
  add_strips(first_, second_);
  add_strips(second_, first_);
}

bool is_at_flush_rim(const ContactStepContext& context, SurfaceNodeIndex row, FaceIndex face,
                     const Eigen::Vector3d& normal) {
  const ContactMesh& contact_mesh = context.kinematics.contact_mesh();
  const SurfaceNode& node = contact_mesh.surface_nodes[row];
  const auto has_rim = [&](FaceIndex index) { return contact_mesh.faces[index].sharpness >= min_rim; };
  if (!has_rim(face) && std::ranges::none_of(contact_mesh.faces_of_node.of(node.node), has_rim)) return false;
  const Eigen::Vector3d closing =
      context.kinematics.v(node.node) - context.kinematics.bound(face).velocity().cast<double>();
  const FaceCorners other = context.kinematics.face_corners(face);
  const std::array<Eigen::Vector3d, 4> corners{other.col(0), other.col(1), other.col(2), other.col(3)};
  std::vector<Eigen::Vector3d> own_points;
  for (const FaceIndex own : contact_mesh.faces_of_node.of(node.node)) {
    if (contact_mesh.faces[own].surface != node.surface) continue;
    if (!(context.kinematics.bound(own).normal().cast<double>().dot(normal) < max_skew)) continue;
    const ContactFace& opposed = contact_mesh.faces[face];
    if (lie_in_strip(context, own, {closing, normal, 1.0, opposed.corners, opposed.surface}, corners))
      return true;
    for (const ContactNodeIndex corner : contact_mesh.faces[own].corners)
      own_points.push_back(context.kinematics.x(corner));
  }
  if (own_points.empty()) own_points.push_back(context.kinematics.x(node.node));
  return lie_in_strip(context, face, {-closing, -normal, 1.0, {&node.node, 1}, node.surface}, own_points);
}

}  // namespace contactsim

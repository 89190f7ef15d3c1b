// SPDX-License-Identifier: BSD-3-Clause
#include "contact/flush_rims.hpp"

#include <algorithm>
#include <cmath>

#include "contact/common_plane.hpp"

namespace contactsim {

namespace {

/// Faces whose normals have a smaller cosine have a rim between them.
constexpr double sharpest_smooth = 0.7;

/// A face whose surroundings turn by less at the start has no rim, though it may bend somewhat [degrees].
constexpr float least_rim = 35.0f;

/// A strip may be this much wider than the penetration of the face beyond the rim was deep: rims may be
/// deeper than the face's middle, and what carries a body gives way by some layers of elements where the next
/// part, which carries nothing, does not. A penalty or a step is as soft as three layers.
constexpr double over_depth = 4.0;

/// Faces are flush though they miss each other by this share of half a side face's height, once the face
/// beyond the rim touches.
constexpr double just_flush = 1e-2;

/// Side faces inside a joint look at each other, askew by some 50 degrees at most, as a cosine.
constexpr float most_askew = -0.65f;

/// What lies before a side face, as seen from its rims.
struct Ahead {
  Eigen::Vector3d closing;                  ///< velocity of the side face relative to it [length/time]
  Eigen::Vector3d normal;                   ///< of the other side there [1]
  std::span<const Eigen::Vector3d> points;  ///< [length]
  double share = 1.0;                       ///< of the strip's width that they may lie behind the rim [1]
  std::span<const std::uint32_t> corners;   ///< contact nodes of the other side's place
  std::uint32_t surface = 0;                ///< of the other side
};

/// Whether some face at the corners of what lies ahead looks against a direction, and turns away from what
/// lies ahead: only where the faces beyond both rims lie flat on each other does a side face rise by so
/// little that it is none. A sheet that is bent over the rim turns towards it.
bool has_opposite(const ContactScene& scene, const Ahead& ahead, const Eigen::Vector3d& out) {
  constexpr double opposite = -0.9;
  const ContactFaces& faces = scene.surface.faces();
  return std::ranges::any_of(ahead.corners, [&](std::uint32_t corner) {
    const Eigen::Vector3d x = scene.surface.x(corner);
    return std::ranges::any_of(faces.faces_of_node.of(corner), [&](std::uint32_t face) {
      const FaceBound& bound = scene.surface.bound(face);
      return faces.faces[face].surface == ahead.surface &&
             bound.normal().cast<double>().dot(out) < opposite &&
             (scene.surface.face(face).x.rowwise().mean() - x).dot(ahead.normal) <= 0.0;
    });
  });
}

/// Whether all points lie in the strip of a side face below one of its rims.
bool lie_in_strip(const ContactScene& scene, std::uint32_t face, const Ahead& ahead) {
  const ContactFaces& faces = scene.surface.faces();
  const ContactFace& side = faces.faces[face];
  if (side.sharpness < least_rim) return false;
  const Eigen::Vector3d normal = scene.surface.area(side).normalized();
  const Eigen::Vector3d centre = 0.25 * (scene.surface.x(side.corners[0]) + scene.surface.x(side.corners[1]) +
                                         scene.surface.x(side.corners[2]) + scene.surface.x(side.corners[3]));
  for (const std::uint32_t corner : side.corners) {
    const Eigen::Vector3d x = scene.surface.x(corner);
    for (const std::uint32_t beyond : faces.faces_of_node.of(corner)) {
      if (faces.faces[beyond].surface != side.surface || beyond == face) continue;
      const Eigen::Vector3d out = scene.surface.area(faces.faces[beyond]).normalized();
      const double height = (x - centre).dot(out);
      if (out.dot(normal) > sharpest_smooth || !(height > 0.0)) continue;
      if (out.dot(ahead.normal) < most_askew)
        continue;  // it is the face beyond that stands on what lies ahead
      const double touched = flush_width(scene, beyond);
      if (!(touched > 0.0) || !has_opposite(scene, ahead, out)) continue;
      const double closed = std::max(0.0, ahead.closing.dot(out)) * scene.dt;
      const double width = std::min(touched + just_flush * height + closed, height) * ahead.share;
      if (std::ranges::all_of(ahead.points, [&](const auto& point) { return (x - point).dot(out) <= width; }))
        return true;
    }
  }
  return false;
}

}  // namespace

double flush_width(const ContactScene& scene, std::uint32_t face) {
  return scene.depths != nullptr ? over_depth * scene.depths->of(face) : 0.0;
}

bool is_at_flush_rim(const ContactScene& scene, std::uint32_t first, std::uint32_t second,
                     const FaceFaceContact& contact) {
  const ContactFace &a_face = scene.surface.faces().faces[first],
                    &b_face = scene.surface.faces().faces[second];
  if (a_face.sharpness < least_rim && b_face.sharpness < least_rim) return false;
  const FaceBound &a = scene.surface.bound(first), &b = scene.surface.bound(second);
  // Only slivers: a square has twice the area of its radius squared.
  const double radius = std::min(a.radius(), b.radius());
  if (contact.area > radius * radius) return false;
  if (a.normal().dot(b.normal()) > most_askew) return false;
  const Eigen::Vector3d centre = scene.surface.face(first).x * contact.weights_1;
  const Eigen::Vector3d closing = (a.velocity() - b.velocity()).cast<double>();
  constexpr double centre_of_strip = 0.5;
  return lie_in_strip(scene, first,
                      {closing,
                       b.normal().cast<double>(),
                       {&centre, 1},
                       centre_of_strip,
                       b_face.corners,
                       b_face.surface}) ||
         lie_in_strip(scene, second,
                      {-closing,
                       a.normal().cast<double>(),
                       {&centre, 1},
                       centre_of_strip,
                       a_face.corners,
                       a_face.surface});
}

bool is_at_flush_rim(const ContactScene& scene, std::uint32_t row, std::uint32_t face,
                     const Eigen::Vector3d& normal) {
  const ContactFaces& faces = scene.surface.faces();
  const SurfaceNode& node = faces.surface_nodes[row];
  const auto has_rim = [&](std::uint32_t index) { return faces.faces[index].sharpness >= least_rim; };
  if (!has_rim(face) && std::ranges::none_of(faces.faces_of_node.of(node.node), has_rim)) return false;
  const Eigen::Vector3d closing =
      scene.surface.v(node.node) - scene.surface.bound(face).velocity().cast<double>();
  const FaceCorners other = scene.surface.face(face).x;
  const std::array<Eigen::Vector3d, 4> corners{other.col(0), other.col(1), other.col(2), other.col(3)};
  std::vector<Eigen::Vector3d> own_points;
  for (const std::uint32_t own : faces.faces_of_node.of(node.node)) {
    if (faces.faces[own].surface != node.surface) continue;
    if (!(scene.surface.bound(own).normal().cast<double>().dot(normal) < most_askew)) continue;
    const ContactFace& opposed = faces.faces[face];
    if (lie_in_strip(scene, own, {closing, normal, corners, 1.0, opposed.corners, opposed.surface}))
      return true;
    for (const std::uint32_t corner : faces.faces[own].corners) own_points.push_back(scene.surface.x(corner));
  }
  if (own_points.empty()) own_points.push_back(scene.surface.x(node.node));
  return lie_in_strip(scene, face, {-closing, -normal, own_points, 1.0, {&node.node, 1}, node.surface});
}

}  // namespace contactsim

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

/// Faces are flush though they miss each other by this share of half a side face's height.
constexpr double just_flush = 2e-3;

/// Side faces in a joint push along each other's normals. Where the push leans towards the face beyond the
/// rim by this cosine, an edge is being hit.
constexpr double most_lean = 0.25;

/// What lies before a side face, as seen from its rims.
struct Ahead {
  Eigen::Vector3d closing;                  ///< velocity of the side face relative to it [length/time]
  std::span<const Eigen::Vector3d> points;  ///< [length]
  double share = 1.0;                       ///< of the strip's width that they may lie behind the rim [1]
  /// Unit, by which the side face would be pushed back; zero: not looked at [1].
  Eigen::Vector3d push = Eigen::Vector3d::Zero();
};

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
      if (-ahead.push.dot(out) > most_lean) continue;
      const double closed = std::max(0.0, ahead.closing.dot(out)) * scene.dt;
      const double width =
          std::min(flush_width(scene, beyond) + just_flush * height + closed, height) * ahead.share;
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
  const FaceBound &a = scene.surface.bound(first), &b = scene.surface.bound(second);
  // Only slivers: a square has twice the area of its radius squared.
  const double radius = std::min(a.radius(), b.radius());
  if (contact.area > radius * radius) return false;
  const Eigen::Vector3d centre = scene.surface.face(first).x * contact.weights_1;
  const Eigen::Vector3d closing = (a.velocity() - b.velocity()).cast<double>();
  constexpr double centre_of_strip = 0.5;
  return lie_in_strip(scene, first, {closing, {&centre, 1}, centre_of_strip, contact.normal}) ||
         lie_in_strip(scene, second, {-closing, {&centre, 1}, centre_of_strip, -contact.normal});
}

bool is_at_flush_rim(const ContactScene& scene, std::uint32_t row, std::uint32_t face,
                     const Eigen::Vector3d& normal) {
  const ContactFaces& faces = scene.surface.faces();
  const SurfaceNode& node = faces.surface_nodes[row];
  const Eigen::Vector3d closing =
      scene.surface.v(node.node) - scene.surface.bound(face).velocity().cast<double>();
  const FaceCorners other = scene.surface.face(face).x;
  const std::array<Eigen::Vector3d, 4> corners{other.col(0), other.col(1), other.col(2), other.col(3)};
  std::vector<Eigen::Vector3d> own_points;
  for (const std::uint32_t own : faces.faces_of_node.of(node.node)) {
    if (faces.faces[own].surface != node.surface) continue;
    if (!(scene.surface.bound(own).normal().cast<double>().dot(normal) < most_aside)) continue;
    if (lie_in_strip(scene, own, {closing, corners})) return true;
    for (const std::uint32_t corner : faces.faces[own].corners) own_points.push_back(scene.surface.x(corner));
  }
  if (own_points.empty()) own_points.push_back(scene.surface.x(node.node));
  return lie_in_strip(scene, face, {-closing, own_points});
}

}  // namespace contactsim

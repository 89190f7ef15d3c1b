// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/node_share.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/formulations/covered_share.hpp"
#include "contact/geometry/common_plane.hpp"

namespace contactsim {

namespace {

/// Where a node meets the other side.
struct MetFace {
  FaceIndex face;
  Eigen::Vector4d weights;  ///< of its corners [1]
};

/// Two surfaces that lie on each other along a normal, whose nodes meet each other's faces.
class Interface {
 public:
  Interface(const ContactStepContext& context, const NodeFaceLists& node_faces, const NearPair& near_pair)
      : kinematics_(context.kinematics),
        context_(context),
        node_faces_(node_faces),
        tolerance_(near_pair.tolerance),
        normal_(kinematics_.area(mesh().faces[near_pair.second]).normalized()) {}

  /// The nearest face of a surface, along the interface, that a node projects inside.
  std::optional<MetFace> find_met(SurfaceNodeIndex row, SurfaceIndex surface) const {
    std::optional<MetFace> met;
    double nearest = std::numeric_limits<double>::infinity();
    for (const FaceIndex face : node_faces_.of(row)) {
      if (mesh().faces[face].surface != surface || !lies_along(face)) continue;
      const auto point = find_closest_point(context_, row, face, tolerance_);
      if (!point || !(std::abs(point->gap) + point->beyond < nearest)) continue;
      nearest = std::abs(point->gap) + point->beyond;
      met = {face, corner_weights(point->xi, point->eta, mesh().faces[face].is_triangle())};
    }
    return met;
  }

  /// The sum of weight times share(row, met) over the corners of a face that meet a surface.
  template <class Share>
  double sum_over_met_corners(const MetFace& at, SurfaceIndex surface, const Share& share) const {
    const ContactFace& face = mesh().faces[at.face];
    double sum = 0.0;
    for (std::size_t k = 0; k < (face.is_triangle() ? 3u : 4u); ++k) {
      const double weight = at.weights[static_cast<Eigen::Index>(k)];
      const auto row = weight > 0.0 ? mesh().find_row(face.corners[k], face.surface) : std::nullopt;
      const auto met = row ? find_met(*row, surface) : std::nullopt;
      if (met) sum += weight * share(*row, *met);
    }
    return sum;
  }

  /// The share of a node of the surface that leads.
  double leading_share(SurfaceNodeIndex row, const MetFace& met) const {
    const SurfaceIndex own = mesh().surface_nodes[row].surface, other = mesh().faces[met.face].surface;
    const double left = sum_over_met_corners(met, own, [&](SurfaceNodeIndex corner, const MetFace&) {
      return is_at_rim(corner, own) ? 0.0 : 1.0;
    });
    return 1.0 - (left > 0.0 && is_at_rim(row, other) ? 1.0 : 0.5) * std::min(left, 1.0);
  }

  /// What the corners of a face of that surface leave to a node of another.
  double following_share(SurfaceIndex own, const MetFace& met) const {
    const double all = sum_over_met_corners(met, own, [](auto, const auto&) { return 1.0; });
    if (!(all > 0.0)) return 1.0;
    return 1.0 - sum_over_met_corners(met, own, [this](SurfaceNodeIndex row, const MetFace& at) {
                   return leading_share(row, at);
                 }) / all;
  }

 private:
  const ContactMesh& mesh() const { return kinematics_.contact_mesh(); }
  bool lies_along(FaceIndex face) const {
    const Eigen::Vector3d area = kinematics_.area(mesh().faces[face]);
    return std::abs(area.dot(normal_)) > -max_facing_cosine * area.norm();
  }
  /// Whether some node around a node does not meet the other side.
  bool is_at_rim(SurfaceNodeIndex row, SurfaceIndex other) const {
    const SurfaceNode& node = mesh().surface_nodes[row];
    return std::ranges::any_of(mesh().faces_of_node.of(node.node), [&](FaceIndex face) {
      const ContactFace& own = mesh().faces[face];
      return own.surface == node.surface && lies_along(face) &&
             std::ranges::any_of(own.corners, [&](ContactNodeIndex corner) {
               const auto around = mesh().find_row(corner, own.surface);
               return corner != node.node && around && !find_met(*around, other);
             });
    });
  }

  const ContactKinematics& kinematics_;
  const ContactStepContext& context_;
  const NodeFaceLists& node_faces_;
  double tolerance_;
  Eigen::Vector3d normal_;
};

/// Whether the side of a node leads, or that of a face.
bool leads(const ContactMesh& contact_mesh, const SurfaceNode& node, FaceIndex face) {
  const SurfaceIndex other = contact_mesh.faces[face].surface;
  if (node.surface != other) return node.surface < other;
  const auto own = contact_mesh.faces_of_node.of(node.node);
  return !own.empty() && own.front() < face;
}

}  // namespace

double node_share(const ContactStepContext& context, const NodeFaceLists& node_faces,
                  const NearPair& near_pair, const Eigen::Vector4d& weights) {
  if (context.rules[near_pair.pair].pair->is_one_sided) return 1.0;
  const ContactMesh& contact_mesh = context.kinematics.contact_mesh();
  const SurfaceNode& node = contact_mesh.surface_nodes[near_pair.row()];
  const Interface interface(context, node_faces, near_pair);
  const MetFace met{near_pair.second, weights};
  const double share = leads(contact_mesh, node, near_pair.second)
                           ? interface.leading_share(near_pair.row(), met)
                           : interface.following_share(node.surface, met);
  return std::max(share, 0.0) * covered_share(context.kinematics, node, near_pair.second);
}

}  // namespace contactsim

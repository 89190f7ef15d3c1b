// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/crossed_sheets.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <utility>

#include "contact/geometry/node_face.hpp"
#include "contact/overlap/point_box.hpp"
#include "contact/search/broad_phase.hpp"

namespace contactsim {

namespace {

using Way = std::array<Eigen::Vector3d, 2>;

Eigen::Vector3d at(const Way& way, double share) { return way[0] + share * (way[1] - way[0]); }

/// Whether a point goes through a face by the triangles about its middle, and changes its side of the face as
/// contact sees it, which is bilinear.
bool is_on_other_side(const Way& point, const std::array<Way, 4>& corners, bool is_triangle) {
  bool may = is_triangle && goes_through(point, {corners[0], corners[1], corners[2]});
  Way middle;
  for (std::size_t k = 0; k < 2; ++k)
    middle[k] = 0.25 * (corners[0][k] + corners[1][k] + corners[2][k] + corners[3][k]);
  for (std::size_t k = 0; k < 4 && !is_triangle && !may; ++k)
    may = goes_through(point, {corners[k], corners[(k + 1) % 4], middle});
  if (!may) return false;
  std::array<double, 2> gap{};
  for (std::size_t i = 0; i < 2; ++i) {
    FaceCorners x;
    for (std::size_t k = 0; k < 4; ++k) x.col(static_cast<Eigen::Index>(k)) = corners[k][i];
    const auto closest = project_onto_face(x, is_triangle, point[i]);
    if (!closest) return true;
    gap[i] = closest->gap;
  }
  return gap[0] * gap[1] < 0.0;
}

}  // namespace

bool goes_through(const std::array<Eigen::Vector3d, 2>& point,
                  const std::array<std::array<Eigen::Vector3d, 2>, 3>& triangle) {
  // Twice the area times the height of the point above the plane; a cubic in the share of the way.
  const auto height = [&](double share) {
    const Eigen::Vector3d a = at(triangle[0], share);
    return (at(triangle[1], share) - a).cross(at(triangle[2], share) - a).dot(at(point, share) - a);
  };
  double low = 0.0, high = 1.0, at_low = height(0.0);
  if (!(at_low * height(1.0) < 0.0)) return false;
  constexpr int halvings = 40;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high), there = height(middle);
    (there * at_low > 0.0 ? low : high) = middle;
  }
  const Eigen::Vector3d a = at(triangle[0], low), b = at(triangle[1], low), c = at(triangle[2], low),
                        p = at(point, low);
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  return (b - a).cross(p - a).dot(normal) >= 0.0 && (c - b).cross(p - b).dot(normal) >= 0.0 &&
         (a - c).cross(p - c).dot(normal) >= 0.0;
}

std::vector<SheetCrossing> find_crossed_sheets(const ContactMesh& contact_mesh, const PairRules& rules,
                                               IndexedSpan<ContactNodeIndex, const Eigen::Vector3d> before,
                                               IndexedSpan<ContactNodeIndex, const Eigen::Vector3d> now) {
  std::vector<FaceIndex> sheets;
  for (const FaceIndex i : indices(contact_mesh.faces)) {
    const ContactFace& face = contact_mesh.faces[i];
    // The bottom has the same mid surface; a surface may have one of the two alone.
    if (contact_mesh.is_lofted(face)) sheets.push_back(i);
  }
  if (sheets.empty()) return {};
  const auto way = [&](ContactNodeIndex node) { return Way{before[node], now[node]}; };
  BroadPhase rows, faces;
  const auto unsound_rows = rows.update(indices(contact_mesh.surface_nodes), [&](SurfaceNodeIndex row) {
    const ContactNodeIndex node = contact_mesh.surface_nodes[row].node;
    Box box = empty_box();
    for (const Eigen::Vector3d& x : way(node)) add_point(x, box);
    return box;
  });
  const auto unsound_faces = faces.update(static_cast<std::uint32_t>(sheets.size()), [&](std::uint32_t i) {
    Box box = empty_box();
    for (const ContactNodeIndex corner : contact_mesh.faces[sheets[i]].corners) {
      for (const Eigen::Vector3d& x : way(corner)) add_point(x, box);
    }
    return box;
  });
  if (unsound_rows || unsound_faces) return {};
  const auto has_gone_through = [&](SurfaceNodeIndex row, std::uint32_t i) {
    const SurfaceNode& node = contact_mesh.surface_nodes[row];
    const ContactFace& face = contact_mesh.faces[sheets[i]];
    if (!rules.find(node.surface, face.surface)) return false;
    const auto hangs_on = [&](ContactNodeIndex corner) {
      return contact_mesh.mesh_nodes[corner] == contact_mesh.mesh_nodes[node.node];
    };
    if (std::ranges::any_of(face.corners, hangs_on)) return false;
    return is_on_other_side(
        way(node.node),
        {way(face.corners[0]), way(face.corners[1]), way(face.corners[2]), way(face.corners[3])},
        face.is_triangle());
  };
  PairLists<SurfaceNodeIndex, std::uint32_t> found;
  rows.find_pairs(faces, has_gone_through, found);
  std::set<std::pair<PairIndex, NodeIndex>> crossings;
  for (const SurfaceNodeIndex row : indices(contact_mesh.surface_nodes)) {
    const SurfaceNode& node = contact_mesh.surface_nodes[row];
    for (const std::uint32_t i : found.of(row)) {
      const auto pair = rules.find(node.surface, contact_mesh.faces[sheets[i]].surface);
      crossings.emplace(*pair, contact_mesh.mesh_nodes[node.node]);
    }
  }
  std::vector<SheetCrossing> listed;
  for (const auto& [pair, node] : crossings) listed.push_back({pair, node});
  return listed;
}

}  // namespace contactsim

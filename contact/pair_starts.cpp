// SPDX-License-Identifier: BSD-3-Clause
#include "contact/pair_starts.hpp"

#include <cmath>

#include "contact/contact_search.hpp"
#include "contact/node_face.hpp"
#include "contact/penalty.hpp"

namespace contactsim {

namespace {

/// Counts a candidate, and its gap where it has one.
void note(std::optional<double> gap, PairStart& start) {
  ++start.n_in_reach;
  if (gap && !(start.smallest_gap <= *gap)) start.smallest_gap = *gap;
}

/// The least gap between two faces; nothing when contact would not take them: too deep, or deeper than wide
/// as the sides of two bodies that overlap at an edge.
std::optional<double> gap_of_faces(const MovingSurface& surface, const SurfacePair& pair, std::uint32_t first,
                                   std::uint32_t second) {
  const auto found = find_face_face_points(surface.face(first), surface.face(second));
  if (!found) return std::nullopt;
  double least = std::numeric_limits<double>::infinity();
  for (const OverlapBatch& batch : found->points.batches())
    least = std::min(least, (batch.weight > 0.0).select(batch.gap, least).minCoeff());
  const ContactFaces& faces = surface.faces();
  const double depth =
      make_pair_penalty(faces.faces[first].backing, &faces.faces[second].backing, pair).depth;
  const bool is_contact = -least <= depth && -least <= std::sqrt(found->points.area);
  return is_contact ? std::optional(least) : std::nullopt;
}

std::optional<double> gap_of_node(const MovingSurface& surface, const SurfacePair& pair, std::uint32_t row,
                                  std::uint32_t face) {
  const MovingFace moving = surface.face(face);
  const SurfaceNode& node = surface.faces().surface_nodes[row];
  const auto point = project_ball(moving.x, moving.is_triangle, surface.x(node.node), node.radius);
  const double depth = make_pair_penalty(node.backing, &surface.faces().faces[face].backing, pair).depth;
  if (!point || point->edge >= 0 || -point->gap > depth) return std::nullopt;
  return point->gap;
}

/// The gap of a node is that to the nearest face.
void add_node(const MovingSurface& surface, const PairRules& rules, const PairLists& node_faces,
              std::uint32_t row, std::vector<PairStart>& starts) {
  const ContactFaces& faces = surface.faces();
  std::optional<double> nearest;
  std::uint32_t of = PairRules::none;
  for (const std::uint32_t face : node_faces.of(row)) {
    const std::uint32_t pair = rules.find(faces.surface_nodes[row].surface, faces.faces[face].surface);
    note(std::nullopt, starts[pair]);
    const auto gap = gap_of_node(surface, *rules[pair].pair, row, face);
    if (!gap || (nearest && std::abs(*gap) >= std::abs(*nearest))) continue;
    nearest = gap;
    of = pair;
  }
  if (nearest && !(starts[of].smallest_gap <= *nearest)) starts[of].smallest_gap = *nearest;
}

/// Gaps to planes.
void add_planes(const ContactModel& model, const MovingSurface& surface, std::vector<PairStart>& starts) {
  const ContactFaces& faces = surface.faces();
  for (std::size_t i = 0; i < model.pairs.size(); ++i) {
    const SurfacePair& pair = model.pairs[i];
    const auto add = [&](std::uint32_t with_plane, std::uint32_t other) {
      for (const std::uint32_t plane : model.surfaces.surfaces[with_plane].analytic_planes) {
        const AnalyticPlane& wall = model.planes[plane];
        for (std::uint32_t n = faces.first_node[other]; n < faces.first_node[other + 1]; ++n) {
          const Eigen::Vector3d away = surface.x(faces.surface_nodes[n].node) - wall.origin;
          note(away.dot(wall.normal.normalized()) - faces.surface_nodes[n].radius, starts[i]);
        }
      }
    };
    add(pair.first, pair.second);
    if (pair.first != pair.second) add(pair.second, pair.first);
  }
}

}  // namespace

std::vector<PairStart> find_pair_starts(const ContactModel& model, const Mesh& mesh,
                                        const DashOptions& dash) {
  std::vector<PairStart> starts(model.pairs.size());
  const ContactFaces faces = make_contact_faces(model, mesh);
  const PairRules rules(model.pairs, std::vector<ActiveTimes>(model.pairs.size()),
                        model.surfaces.surfaces.size());
  MovingSurface surface(faces);
  const Eigen::Matrix3Xd at_rest = Eigen::Matrix3Xd::Zero(3, mesh.n_nodes());
  const Motion motion{0.0, 0.0, mesh.coordinates(), at_rest};
  surface.move_nodes(motion);
  surface.bound_all();
  ContactSearch search(faces, mesh, rules, {}, dash);
  PairLists face_partners, node_faces;
  search.find(surface, motion, {face_partners, node_faces});
  for (std::uint32_t a = 0; a < face_partners.n_rows(); ++a) {
    for (const std::uint32_t b : face_partners.of(a)) {
      const std::uint32_t pair = rules.find(faces.faces[a].surface, faces.faces[b].surface);
      note(gap_of_faces(surface, *rules[pair].pair, a, b), starts[pair]);
    }
  }
  for (std::uint32_t row = 0; row < node_faces.n_rows(); ++row)
    add_node(surface, rules, node_faces, row, starts);
  add_planes(model, surface, starts);
  return starts;
}

}  // namespace contactsim

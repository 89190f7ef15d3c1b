// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/initial_gaps.hpp"

#include <cmath>

#include "contact/formulations/penalty.hpp"
#include "contact/geometry/node_face.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/search/contact_search.hpp"

namespace contactsim {

namespace {

/// Counts a candidate, and its gap where it has one.
void note(std::optional<double> gap, InitialGap& start) {
  ++start.n_in_reach;
  if (gap && !(start.smallest_gap <= *gap)) start.smallest_gap = *gap;
}

/// The least gap between two faces; nothing when contact would not take them: too deep, or deeper than wide
/// as the sides of two bodies that overlap at an edge.
std::optional<double> gap_of_faces(const ContactKinematics& kinematics, const SurfacePair& pair,
                                   std::uint32_t first, std::uint32_t second) {
  const auto found = find_face_face_points(kinematics.face(first), kinematics.face(second));
  if (!found) return std::nullopt;
  double least = std::numeric_limits<double>::infinity();
  for (const OverlapBatch& batch : found->points.batches())
    least = std::min(least, (batch.weight > 0.0).select(batch.gap, least).minCoeff());
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  const double depth = make_pair_penalty(contact_mesh.faces[first].penalty_properties,
                                         &contact_mesh.faces[second].penalty_properties, pair)
                           .depth;
  const bool is_contact = -least <= depth && -least <= std::sqrt(found->points.area);
  return is_contact ? std::optional(least) : std::nullopt;
}

std::optional<double> gap_of_node(const ContactKinematics& kinematics, const SurfacePair& pair,
                                  std::uint32_t row, std::uint32_t face) {
  const MovingFace moving = kinematics.face(face);
  const SurfaceNode& node = kinematics.contact_mesh().surface_nodes[row];
  const auto point = project_sphere(moving.x, moving.is_triangle, kinematics.x(node.node), node.radius);
  const double depth = make_pair_penalty(node.penalty_properties,
                                         &kinematics.contact_mesh().faces[face].penalty_properties, pair)
                           .depth;
  if (!point || point->edge >= 0 || -point->gap > depth) return std::nullopt;
  return point->gap;
}

/// The gap of a node is that to the nearest face.
void add_node(const ContactKinematics& kinematics, const PairRules& rules, const PairLists& node_faces,
              std::uint32_t row, std::vector<InitialGap>& starts) {
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  std::optional<double> nearest;
  OptionalIndex of;
  for (const std::uint32_t face : node_faces.of(row)) {
    const std::uint32_t pair =
        *rules.find(contact_mesh.surface_nodes[row].surface, contact_mesh.faces[face].surface);
    note(std::nullopt, starts[pair]);
    const auto gap = gap_of_node(kinematics, *rules[pair].pair, row, face);
    if (!gap || (nearest && std::abs(*gap) >= std::abs(*nearest))) continue;
    nearest = gap;
    of = pair;
  }
  if (nearest && !(starts[*of].smallest_gap <= *nearest)) starts[*of].smallest_gap = *nearest;
}

/// Gaps to planes.
void add_planes(const ContactModel& model, const ContactKinematics& kinematics,
                std::vector<InitialGap>& starts) {
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  for (std::size_t i = 0; i < model.pairs.size(); ++i) {
    const SurfacePair& pair = model.pairs[i];
    const auto add = [&](std::uint32_t with_plane, std::uint32_t other) {
      for (const std::uint32_t plane : model.surfaces.surfaces[with_plane].analytic_planes) {
        const AnalyticPlane& wall = model.planes[plane];
        for (std::uint32_t n = contact_mesh.first_node[other]; n < contact_mesh.first_node[other + 1]; ++n) {
          const Eigen::Vector3d away = kinematics.x(contact_mesh.surface_nodes[n].node) - wall.origin;
          note(away.dot(wall.normal.normalized()) - contact_mesh.surface_nodes[n].radius, starts[i]);
        }
      }
    };
    add(pair.first, pair.second);
    if (pair.first != pair.second) add(pair.second, pair.first);
  }
}

}  // namespace

std::vector<InitialGap> find_initial_gaps(const ContactModel& model, const Mesh& mesh,
                                          const DashOptions& dash) {
  std::vector<InitialGap> starts(model.pairs.size());
  const ContactMesh contact_mesh = make_contact_mesh(model, mesh);
  const PairRules rules(model.pairs, std::vector<ActiveTimes>(model.pairs.size()),
                        model.surfaces.surfaces.size());
  ContactKinematics kinematics(contact_mesh);
  const Eigen::Matrix3Xd at_rest = Eigen::Matrix3Xd::Zero(3, mesh.n_nodes());
  const Motion motion{0.0, 0.0, mesh.coordinates(), at_rest};
  kinematics.move_nodes(motion);
  kinematics.bound_all();
  ContactSearch search(contact_mesh, mesh, rules, {}, dash);
  PairLists face_partners, node_faces;
  search.find_face_pairs(kinematics, motion, {}, face_partners);
  search.find_node_faces(kinematics, motion, {}, node_faces);
  for (std::uint32_t a = 0; a < face_partners.n_rows(); ++a) {
    for (const std::uint32_t b : face_partners.of(a)) {
      const std::uint32_t pair = *rules.find(contact_mesh.faces[a].surface, contact_mesh.faces[b].surface);
      note(gap_of_faces(kinematics, *rules[pair].pair, a, b), starts[pair]);
    }
  }
  for (std::uint32_t row = 0; row < node_faces.n_rows(); ++row)
    add_node(kinematics, rules, node_faces, row, starts);
  add_planes(model, kinematics, starts);
  return starts;
}

}  // namespace contactsim

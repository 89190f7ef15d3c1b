// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "contact/enforcement/contact_force.hpp"
#include "contact/enforcement/finer_surfaces.hpp"
#include "contact/enforcement/penalty_limits.hpp"
#include "contact/formulations/start_depths.hpp"
#include "contact/mesh/feature_edges.hpp"
#include "contact/mesh/smooth_surfaces.hpp"
#include "core/base/state_archive.hpp"
#include "core/definition/contact.hpp"

namespace contactsim {

namespace {

/// Nodes of the mesh that an edge hangs on, the lower one first.
std::pair<NodeIndex, NodeIndex> mesh_nodes_of(const ContactMesh& contact_mesh, const ContactEdge& edge) {
  return std::minmax(contact_mesh.mesh_nodes[edge.nodes[0]], contact_mesh.mesh_nodes[edge.nodes[1]]);
}

/// Sharp edges stay that were there before.
void take_off_new_edges(const ContactMesh& before, ContactMesh& contact_mesh) {
  std::set<std::pair<NodeIndex, NodeIndex>> known;
  for (const ContactEdge& edge : before.edges) known.insert(mesh_nodes_of(before, edge));
  std::erase_if(contact_mesh.edges, [&](const ContactEdge& edge) {
    return edge.is_sharp() && !known.contains(mesh_nodes_of(contact_mesh, edge));
  });
}

/// Whether both sides of a contact point are still there; it has their new numbers then.
bool keep_point(const ContactRemap& remap, ContactPoint& point) {
  const bool is_node = point.first.is_node() && !point.is_of_edges;
  const bool is_plane = point.second.weights.isZero(0.0);
  const auto after = [&](bool is_row, std::uint32_t entity) {
    if (point.is_of_edges) return number_after(remap.edges, entity);
    return is_row ? number_after(remap.rows, entity) : number_after(remap.faces, entity);
  };
  const auto first = after(is_node, point.first_entity);
  const OptionalIndex<std::uint32_t> second =
      is_plane ? point.second_entity : after(false, point.second_entity);
  if (!first || !second) return false;
  point.first_entity = *first;
  point.second_entity = *second;
  for (ContactPointSide* side : {&point.first, &point.second}) {
    if (side == &point.second && is_plane) continue;
    for (ContactNodeIndex& node : side->nodes) node = *remap.nodes[node];
  }
  return true;
}

}  // namespace

ContactMesh ContactForce::make_faces(std::span<const ErodedNode> eroded_nodes) const {
  const Mesh& mesh = *setup_.model.mesh;
  ContactMesh contact_mesh = make_contact_mesh(setup_.contact, mesh, eroded_nodes);
  const ContactKinematics start = kinematics_of_mesh(contact_mesh, mesh);
  choose_feature_edges(setup_.definition.surface_options, setup_.contact.surfaces.surfaces, start,
                       contact_mesh);
  measure_sharpness(start, contact_mesh);
  add_smooth_faces(setup_.contact, start, contact_mesh);
  add_penalty_properties(setup_.model, contact_mesh);
  return contact_mesh;
}

/// Of the surfaces as the mesh has them, which the slips of their nodes follow.
SurfaceTurns ContactForce::make_turns() const {
  if (!rules_.has_friction()) return {};
  return SurfaceTurns(kinematics_of_mesh(contact_mesh_, *setup_.model.mesh));
}

/// The mid surfaces of lofted shells, which turn the points of lofts.
LoftSpins ContactForce::make_spins() const {
  return {contact_mesh_.loft, static_cast<std::size_t>(setup_.model.mesh->coordinates().cols()),
          setup_.model.rigid.nodes};
}

/// Remembers the stiffness behind new faces and nodes, which is that of their elements.
void ContactForce::note_element_stiffness() {
  if (!element_stiffness_.empty()) return;
  const auto note = [&](const auto& items) {
    for (const auto& item : items) element_stiffness_.push_back(item.penalty_properties.stiffness);
  };
  note(contact_mesh_.faces);
  note(contact_mesh_.surface_nodes);
  note(contact_mesh_.edges);
}

/// The stiffness behind faces and nodes as elements have it, limited by what masses and conditions allow now.
///   start  the faces at the start
void ContactForce::limit_stiffness(const ContactKinematics& start) {
  note_element_stiffness();
  const double scale = setup_.is_static() ? static_penalty_scale : 1.0;
  auto of_elements = element_stiffness_.begin();
  const auto begin_anew = [&](auto& items) {
    for (auto& item : items) item.penalty_properties.stiffness = scale * *of_elements++;
  };
  begin_anew(contact_mesh_.faces);
  begin_anew(contact_mesh_.surface_nodes);
  begin_anew(contact_mesh_.edges);
  contactsim::limit_stiffness(start, mobility_, setup_.is_static() ? 0.0 : start_step_, contact_mesh_);
}

void ContactForce::remap(const ContactRemap& remap) {
  rules_.remap(remap);
  constrained_.remap(remap);
  depths_.remap(remap);
  detection_.remap(remap);
  multipliers_.remap(remap);
  held_slips_.remap(remap);
  preload_forces_.clear();
  stabilization_.forget_forces();
  trial_.reset();
  histories_.add_released(detection_.released_faces(), detection_.released_nodes(), contact_mesh_);
  keep_constraints(remap, constraint_forces_);
  assembler_.remap(remap);
  balance_.remap(remap);
  std::erase_if(points_, [&](ContactPoint& point) { return !keep_point(remap, point); });
}

void ContactForce::rebuild_surfaces(const Motion& motion, std::span<const ErodedNode> eroded_nodes,
                                    bool makes_new_edges) {
  const ContactMesh before = std::exchange(contact_mesh_, make_faces(eroded_nodes));
  element_stiffness_.clear();
  weighted_gaps_ = WeightedGaps(find_finer_surfaces(setup_.contact, contact_mesh_));
  if (!makes_new_edges) take_off_new_edges(before, contact_mesh_);
  limit_stiffness(kinematics_of_mesh(contact_mesh_, *setup_.model.mesh));
  leave_surfaces(before, motion);
  histories_.forget_stored(points_, constraint_forces_);
}

/// Goes over to the faces that there are now.
///   before  those of so far
void ContactForce::leave_surfaces(const ContactMesh& before, const Motion& motion) {
  const ContactRemap remap = make_contact_remap(before, contact_mesh_);
  std::ranges::set_difference(std::span(before.mesh_nodes).first(before.n_mesh_points()),
                              std::span(contact_mesh_.mesh_nodes).first(contact_mesh_.n_mesh_points()),
                              std::back_inserter(left_));
  left_.insert(left_.end(), before.mesh_nodes.begin() + static_cast<std::ptrdiff_t>(before.n_mesh_points()),
               before.mesh_nodes.end());
  transfer_start_depths(remap, before, contact_mesh_);
  turns_ = make_turns();
  this->remap(remap);
  kinematics_.turn_by(make_spins());
  kinematics_.hold(mobility_.free_directions());
  kinematics_.remap(remap, motion);
  kinematics_.move_nodes(motion);
  kinematics_.bound_all();
  kinematics_.watch(detection_.faces_with_candidates());
}

ContactCheckpoint ContactForce::checkpoint(const Motion& motion) {
  StateArchive saves;
  archive(motion, saves);
  return {contact_mesh_, element_stiffness_, weighted_gaps_,       assembler_,
          points_,       constraint_forces_, copy_of(saves.take())};
}

void ContactForce::restore(const Motion& motion, const ContactCheckpoint& checkpoint) {
  const ContactMesh before = std::exchange(contact_mesh_, checkpoint.contact_mesh);
  leave_surfaces(before, motion);
  element_stiffness_ = checkpoint.element_stiffness;
  weighted_gaps_ = checkpoint.weighted_gaps;
  assembler_ = checkpoint.assembler;
  points_ = checkpoint.points;
  constraint_forces_ = checkpoint.constraint_forces;
  StateArchive restores(checkpoint.memory);
  archive(motion, restores);
}

}  // namespace contactsim

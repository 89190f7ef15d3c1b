// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "contact/contact_force.hpp"
#include "contact/penalty.hpp"
#include "contact/sharp_edges.hpp"
#include "contact/start_depths.hpp"

namespace contactsim {

namespace {

/// Nodes of the mesh that an edge hangs on, the lower one first.
std::pair<std::uint32_t, std::uint32_t> mesh_nodes_of(const ContactFaces& faces, const ContactEdge& edge) {
  return std::minmax(faces.mesh_nodes[edge.nodes[0]], faces.mesh_nodes[edge.nodes[1]],
                     std::less<std::uint32_t>());
}

/// Sharp edges stay that were there before.
void take_off_new_edges(const ContactFaces& before, ContactFaces& faces) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> known;
  for (const ContactEdge& edge : before.edges) known.insert(mesh_nodes_of(before, edge));
  std::erase_if(faces.edges, [&](const ContactEdge& edge) {
    return edge.is_sharp() && !known.contains(mesh_nodes_of(faces, edge));
  });
}

/// Whether both sides of a contact point are still there; it has their new numbers then.
bool keep_point(const ContactRenumbering& places, ContactRecord& point) {
  constexpr std::uint32_t gone = ContactRenumbering::gone;
  const bool is_node = point.first.is_node() && !point.is_of_edges;
  const bool is_plane = point.second.weights.isZero(0.0);
  point.first_place = (point.is_of_edges ? places.edges
                       : is_node         ? places.rows
                                         : places.faces)[point.first_place];
  if (!is_plane) point.second_place = (point.is_of_edges ? places.edges : places.faces)[point.second_place];
  if (point.first_place == gone || point.second_place == gone) return false;
  for (RecordSide* side : {&point.first, &point.second}) {
    if (side == &point.second && is_plane) continue;
    for (std::uint32_t& node : side->nodes) node = places.nodes[node];
  }
  return true;
}

}  // namespace

ContactFaces ContactForce::make_faces(std::span<const FreeNode> free_nodes) const {
  const Mesh& mesh = *setup_.model.mesh;
  ContactFaces faces = make_contact_faces(setup_.contact, mesh, free_nodes);
  const MovingSurface start = surface_of_mesh(faces, mesh);
  choose_edges(setup_.definition.surface_options, setup_.contact.surfaces.surfaces, start, faces);
  measure_sharpness(start, faces);
  add_backing(setup_.model, faces);
  return faces;
}

/// The stiffness behind faces and nodes as elements have it, limited by what masses and conditions allow now.
///   start  the faces at the start
void ContactForce::limit_stiffness(const MovingSurface& start) {
  std::size_t n = 0;
  const bool is_new = element_stiffness_.empty();
  const auto begin_anew = [&](auto& items) {
    for (auto& item : items) {
      if (is_new) element_stiffness_.push_back(item.backing.stiffness);
      item.backing.stiffness = element_stiffness_[n++];
    }
  };
  begin_anew(faces_.faces);
  begin_anew(faces_.surface_nodes);
  begin_anew(faces_.edges);
  contactsim::limit_stiffness(start, mobility_, start_step_, faces_);
}

void ContactForce::renumber(const ContactRenumbering& places) {
  rules_.renumber(places);
  glued_.renumber(places);
  depths_.renumber(places);
  search_.renumber(places);
  face_face_.renumber(places);
  node_face_.renumber(places);
  edges_.renumber(places);
  planes_.renumber(setup_.contact.surfaces, setup_.contact.planes, rules_, places);
  held_.renumber(places);
  sums_.renumber(places);
  balance_.renumber(places);
  std::erase_if(points_, [&](ContactRecord& point) { return !keep_point(places, point); });
}

void ContactForce::take_surfaces(const Motion& motion, std::span<const FreeNode> free_nodes,
                                 bool makes_new_edges) {
  const ContactFaces before = std::exchange(faces_, make_faces(free_nodes));
  element_stiffness_.clear();
  if (!makes_new_edges) take_off_new_edges(before, faces_);
  limit_stiffness(surface_of_mesh(faces_, *setup_.model.mesh));
  const ContactRenumbering places = contactsim::renumber(before, faces_);
  std::ranges::set_difference(std::span(before.mesh_nodes).first(before.n_mesh_points()),
                              std::span(faces_.mesh_nodes).first(faces_.n_mesh_points()),
                              std::back_inserter(left_));
  left_.insert(left_.end(), before.mesh_nodes.begin() + static_cast<std::ptrdiff_t>(before.n_mesh_points()),
               before.mesh_nodes.end());
  carry_start_depths(places, before, faces_);
  renumber(places);
  surface_.turn_by(make_spins());
  surface_.hold(mobility_.free_directions());
  surface_.renumber(places, motion);
  surface_.move_nodes(motion);
  surface_.bound_all();
  surface_.watch(faces_with_candidates());
  has_new_surfaces_ = true;
  forget_stored();
}

/// What springs stored that are gone is not given back.
void ContactForce::forget_stored() {
  std::fill(stored_.begin(), stored_.end(), 0.0);
  for (const ContactRecord& point : points_) {
    if (point.touches()) stored_[point.pair] += point.stored();
  }
  for (const HeldForces& held : held_.forces()) stored_[held.place.pair] += held.forces.stored;
}

/// Contacts that ended though their sides did not part; those that a pair's period ends are not among them.
void ContactForce::note_lost(double time) {
  std::vector<LostContact> lost;
  face_face_.find_lost(rules_, lost);
  node_face_.find_lost(lost);
  for (const LostContact& one : lost) {
    if (!rules_[one.pair].is_active) continue;
    PairHistory& history = histories_[one.pair];
    if (history.n_lost++ > 0) continue;
    history.lost_node = faces_.mesh_nodes[one.node];
    history.lost_time = time;
    history.lost_depth = one.depth;
  }
}

}  // namespace contactsim

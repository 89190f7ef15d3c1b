// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_detection.hpp"
#include "core/definition/contact.hpp"

namespace contactsim {

ContactDetection::ContactDetection(const ContactSetup& setup, const ContactMesh& contact_mesh,
                                   const PairRules& rules)
    : setup_(setup),
      contact_mesh_(contact_mesh),
      rules_(rules),
      search_(contact_mesh, *setup.model.mesh, rules, setup.definition.search, setup.definition.dash,
              setup.model.rigid.nodes.body_of),
      face_face_(contact_mesh, rules.has_friction()),
      node_face_(contact_mesh),
      edges_(contact_mesh),
      planes_(contact_mesh, setup.contact.surfaces, setup.contact.planes, rules) {}

void ContactDetection::find_candidates(const Motion& motion, ContactKinematics& kinematics) {
  kinematics.bound_all();
  const std::vector<float> node_depths = node_face_.depths();
  search_.find(kinematics, motion,
               {face_face_.next_candidates(), node_face_.candidates(), face_face_.depths(), node_depths});
  face_face_.take_candidates();
  if (!contact_mesh_.edges.empty()) {
    search_.find_edges(kinematics, motion, edges_.next_candidates(), edges_.depths());
    edges_.take_candidates();
  }
  kinematics.watch(faces_with_candidates());
  has_new_surfaces_ = false;
}

/// A node looks at its own faces, too, and at those around the faces that it may touch.
std::vector<std::uint32_t> ContactDetection::faces_with_candidates() const {
  std::vector<std::uint8_t> is_watched(contact_mesh_.faces.size(), 0);
  const PairLists &of_faces = face_face_.candidates(), &of_nodes = node_face_.candidates();
  for (std::size_t row = 0; row < of_faces.n_rows(); ++row) {
    if (!of_faces.of(row).empty()) is_watched[row] = 1;
    for (const std::uint32_t partner : of_faces.of(row)) is_watched[partner] = 1;
  }
  for (std::size_t row = 0; row < of_nodes.n_rows(); ++row) {
    if (of_nodes.of(row).empty()) continue;
    for (const std::uint32_t own : contact_mesh_.faces_of_node.of(contact_mesh_.surface_nodes[row].node))
      is_watched[own] = 1;
    for (const std::uint32_t face : of_nodes.of(row)) {
      is_watched[face] = 1;
      for (const std::uint32_t corner : contact_mesh_.faces[face].corners) {
        for (const std::uint32_t neighbour : contact_mesh_.faces_of_node.of(corner))
          is_watched[neighbour] = 1;
      }
    }
  }
  std::vector<std::uint32_t> watched;
  watched.reserve(static_cast<std::size_t>(std::count(is_watched.begin(), is_watched.end(), 1)));
  for (std::uint32_t face = 0; face < is_watched.size(); ++face) {
    if (is_watched[face] != 0) watched.push_back(face);
  }
  return watched;
}

void ContactDetection::begin_step() {
  face_face_.begin_step();
  node_face_.begin_step();
  edges_.begin_step();
}

std::span<const ContactPoint> ContactDetection::find_node_points(const ContactStepContext& context) {
  node_points_.clear();
  visit_contact_points(node_face_, context,
                       [&](const ContactPoint& point) { node_points_.push_back(point); });
  node_areas_.share_out(context, node_points_);
  return node_points_;
}

void ContactDetection::find_lost(std::vector<LostContact>& lost) const {
  face_face_.find_lost(rules_, lost);
  node_face_.find_lost(lost);
}

NearCandidates ContactDetection::near_candidates() const {
  return {face_face_.candidates(), node_face_.candidates(), setup_.definition.dash.search_length_scaling};
}

std::size_t ContactDetection::n_candidates() const {
  return face_face_.candidates().partners.size() + node_face_.candidates().partners.size() +
         edges_.candidates().partners.size() + planes_.n_rows();
}

void ContactDetection::remap(const ContactRemap& remap) {
  search_.remap(remap);
  face_face_.remap(remap);
  node_face_.remap(remap);
  edges_.remap(remap);
  planes_.remap(setup_.contact.surfaces, setup_.contact.planes, rules_, remap);
  has_new_surfaces_ = true;
}

void ContactDetection::archive(StateArchive& saved) {
  search_.archive(saved);
  face_face_.archive(saved);
  node_face_.archive(saved);
  edges_.archive(saved);
  planes_.archive(saved);
}

}  // namespace contactsim

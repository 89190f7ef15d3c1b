// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "contact/search/contact_search.hpp"

namespace contactsim {

namespace {

/// Marks what was not there before besides what is marked already.
///   is_new  [n before], or empty when nothing was; gets [n_after]
template <class AnIndex>
void mark_new(const NewPositions<AnIndex>& positions, std::size_t n_after,
              IndexedVector<AnIndex, std::uint8_t>& is_new) {
  is_new.resize(positions.size(), 0);
  IndexedVector<AnIndex, std::uint8_t> marks(n_after, 1);
  for (const AnIndex i : indices(positions)) {
    if (positions[i]) marks[*positions[i]] = is_new[i];
  }
  is_new = std::move(marks);
}

/// The largest thickness behind faces and nodes of each surface [length].
IndexedVector<SurfaceIndex, double> thickest_elements(const ContactMesh& contact_mesh) {
  IndexedVector<SurfaceIndex, double> thickest(contact_mesh.n_surfaces(), 0.0);
  const auto look_at = [&](SurfaceIndex surface, double thickness) {
    thickest[surface] = std::max(thickest[surface], thickness);
  };
  for (const ContactFace& face : contact_mesh.faces) look_at(face.surface, face.penalty_properties.thickness);
  for (const SurfaceNode& node : contact_mesh.surface_nodes)
    look_at(node.surface, node.penalty_properties.thickness);
  return thickest;
}

}  // namespace

void ContactSearch::set_margins() {
  const ContactMesh& contact_mesh = contact_mesh_;
  node_margin_.assign(contact_mesh.n_nodes(), std::numeric_limits<float>::infinity());
  face_margin_.clear();
  const ContactKinematics start = kinematics_of_mesh(contact_mesh_, mesh_);
  face_margin_.reserve(contact_mesh_.faces.size());
  for (const ContactFace& face : contact_mesh_.faces) {
    face_margin_.push_back(static_cast<float>(length_scaling_ * std::sqrt(start.area(face).norm())));
    for (const ContactNodeIndex corner : face.corners)
      node_margin_[corner] = std::min(node_margin_[corner], face_margin_.back());
  }
  for (const SurfaceNode& node : contact_mesh.surface_nodes)
    node_margin_[node.node] =
        std::min(node_margin_[node.node], static_cast<float>(length_scaling_ * std::sqrt(node.area)));
  set_surface_margins();
}

void ContactSearch::set_surface_margins() {
  const ContactMesh& contact_mesh = contact_mesh_;
  const std::size_t n_surfaces = contact_mesh.n_surfaces();
  activation_distance_.assign(n_surfaces, 0.0);
  has_start_reach_ = false;
  const IndexedVector<SurfaceIndex, double> thickest = thickest_elements(contact_mesh);
  for (const PairIndex i : indices(rules_.rules())) {
    const SurfacePair& pair = *rules_[i].pair;
    const double least = least_reach_.empty() ? 0.0 : least_reach_[i];
    const double given =
        std::max({least, pair.normal_tolerance.value_or(0.0), pair.tracking_distance.value_or(0.0)});
    // Ties, partners that are kept and clearances reach as far as the deck says; what is held needs no search
    // later.
    const bool looks_far =
        pair.behavior == InteractionBehavior::infinitesimal_sliding || pair.gap.initial_clearance.has_value();
    const double at_start =
        std::max(pair.capture_tolerance.value_or(0.0), looks_far ? rules_.start_reach().distance(i) : 0.0);
    has_start_reach_ = has_start_reach_ || at_start > 0.0;
    const double thickness = std::min(thickest[pair.first], thickest[pair.second]);
    const double held = pair.held_gap(thickness);
    const bool is_static = pair.enforcement == Enforcement::augmented_lagrange;
    for (const SurfaceIndex surface : {pair.first, pair.second})
      activation_distance_[surface] =
          std::max({activation_distance_[surface], given, held, reaches_for_start_ ? at_start : 0.0,
                    is_static ? load_step_reach * thickness : 0.0,
                    rules_.max_activation_distance(i) + rules_.gap_offsets().reach(i)});
  }
  widest_margin_.assign(n_surfaces, 0.0);
  narrowest_margin_.assign(n_surfaces, std::numeric_limits<double>::infinity());
  for (const SurfaceNode& node : contact_mesh.surface_nodes) {
    double& narrowest = narrowest_margin_[node.surface];
    double& widest = widest_margin_[node.surface];
    narrowest = std::min<double>(narrowest, node_margin_[node.node]);
    widest = std::max<double>(widest, node_margin_[node.node]);
  }
  for (const FaceIndex i : indices(contact_mesh.faces)) {
    double& widest = widest_margin_[contact_mesh.faces[i].surface];
    widest = std::max<double>(widest, face_margin_[i]);
  }
}

void ContactSearch::reach_for_start(bool does) {
  reaches_for_start_ = does;
  set_surface_margins();
}

void ContactSearch::remap(const ContactRemap& remap) {
  adjacent_.renew(mesh_);
  set_margins();
  has_eroded_nodes_ = std::ranges::any_of(contact_mesh_.surface_nodes, &SurfaceNode::is_free);
  std::vector<std::size_t> before;
  first_face_partners_ =
      transferred(first_face_partners_, remap.faces, remap.faces, remap.n_faces_after, before);
  first_node_faces_ = transferred(first_node_faces_, remap.rows, remap.faces, remap.n_rows_after, before);
  if (!has_small_sliding_) return;
  mark_new(remap.faces, remap.n_faces_after, is_new_face_);
  mark_new(remap.rows, remap.n_rows_after, is_new_row_);
}

}  // namespace contactsim

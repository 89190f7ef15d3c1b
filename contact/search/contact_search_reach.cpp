// SPDX-License-Identifier: BSD-3-Clause
// How far apart what a search finds may be.
#include <algorithm>

#include "contact/search/contact_search.hpp"

namespace contactsim {

namespace {

/// The largest thickness behind faces and nodes of each surface [length].
IndexedVector<SurfaceIndex, double> thickest_elements(const ContactMesh& contact_mesh) {
  IndexedVector<SurfaceIndex, double> thickest(contact_mesh.n_surfaces(), 0.0);
  const auto add = [&](SurfaceIndex surface, double thickness) {
    thickest[surface] = std::max(thickest[surface], thickness);
  };
  for (const ContactFace& face : contact_mesh.faces) add(face.surface, face.penalty_properties.thickness);
  for (const SurfaceNode& node : contact_mesh.surface_nodes)
    add(node.surface, node.penalty_properties.thickness);
  return thickest;
}

}  // namespace

void ContactSearch::set_activation_distances() {
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
}

void ContactSearch::reach_for_start(bool does) {
  reaches_for_start_ = does;
  set_activation_distances();
}

void ContactSearch::remap(const ContactRemap& remap) {
  filter_.renew();
  margins_.set(contact_mesh_, mesh_, length_scaling_);
  set_activation_distances();
  has_eroded_nodes_ = std::ranges::any_of(contact_mesh_.surface_nodes, &SurfaceNode::is_free);
  first_partners_.remap(remap, has_small_sliding_);
}

}  // namespace contactsim

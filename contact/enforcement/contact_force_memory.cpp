// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "contact/enforcement/contact_force.hpp"
#include "core/base/digest.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

bool are_like(const SurfacePair& a, const SurfacePair& b) {
  return a.first == b.first && a.second == b.second && a.is_one_sided == b.is_one_sided &&
         a.formulation == b.formulation && a.behavior == b.behavior && a.separates == b.separates &&
         a.gap == b.gap && a.law->type == b.law->type;
}

}  // namespace

bool ContactForce::is_like(const ContactForce& earlier) const {
  const SurfacePairs &pairs = setup_.contact.pairs, &others = earlier.setup_.contact.pairs;
  const auto has_same_enforcement = [](const SurfacePair& a, const SurfacePair& b) {
    return a.enforcement == b.enforcement;
  };
  return earlier.setup_.is_static() && std::ranges::equal(pairs, others, are_like) &&
         (!setup_.is_static() || std::ranges::equal(pairs, others, has_same_enforcement)) &&
         surfaces_digest() == earlier.surfaces_digest();
}

void ContactForce::take_over(ContactForce& earlier, const Motion& ended, const Motion& motion) {
  if (!setup_.is_static()) {
    // Found anew: where that procedure went on from its last state alone there are none.
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, ended.coordinates.cols());
    earlier.begin_trials(ended);
    earlier.try_forces(ended, forces, nullptr);
    balance_.begin_pressed(earlier.trial_->points);
    kinematics_.set_offsets(earlier.kinematics_.offsets());
    constrained_ = earlier.constrained_;
    return detection_.begin_with_ties(earlier.ties());
  }
  StateArchive saves;
  earlier.archive(motion, saves);
  const SavedState memory = saves.take();
  StateArchive restores(memory);
  archive(motion, restores);
}

std::uint64_t ContactForce::surfaces_digest() const {
  Digest digest;
  for (const ContactFace& face : contact_mesh_.faces)
    digest.add_values(std::span<const std::uint32_t>(face.corners));
  digest.add_values(std::span<const std::uint32_t>(contact_mesh_.mesh_nodes));
  digest.add_values(std::span<const FaceIndex>(contact_mesh_.first_face));
  digest.add_values(std::span<const SurfaceNodeIndex>(contact_mesh_.first_node));
  for (const ContactEdge& edge : contact_mesh_.edges)
    digest.add_values(std::span<const std::uint32_t>(edge.nodes));
  return digest.value();
}

/// Faces have other stiffnesses than the mesh says, and depths of the start.
void ContactForce::archive_faces(StateArchive& saved) {
  if (saved.restores()) note_element_stiffness();
  saved.expect("contact/surfaces", surfaces_digest(), "contact surfaces");
  saved.expect("contact/n_pairs", setup_.contact.pairs.size(), "contact interactions");
  const auto visit = [](auto& item, RowNumbers& row) {
    row(item.penalty_properties.stiffness, item.penalty_properties.is_rigid,
        item.penalty_properties.start_depth);
  };
  saved.fixed_rows("contact/faces/stiffness", contact_mesh_.faces, visit);
  saved.fixed_rows("contact/nodes/stiffness", contact_mesh_.surface_nodes, visit);
  saved.fixed_rows("contact/edges/stiffness", contact_mesh_.edges, visit);
}

void ContactForce::archive(const Motion& motion, StateArchive& saved) {
  archive_faces(saved);
  kinematics_.archive(saved);
  rules_.archive(saved);
  if (saved.restores()) detection_.resume();
  constrained_.archive(saved);
  depths_.archive(saved);
  detection_.archive(saved);
  assembler_.archive(saved);
  balance_.archive(saved);
  saved.numbers("contact/impact_loss", last_loss_.friction_after, last_loss_.impact_after);
  histories_.archive(saved);
  multipliers_.archive("contact/multipliers", saved);
  held_slips_.archive("contact/held_slips", saved);
  stabilization_.archive(contact_mesh_.n_nodes(), saved);
  saved.numbers("contact/step_share", step_share_.share);
  saved.numbers("contact/stored_at_start", stored_at_start_);
  saved.numbers("contact/start_step", start_step_);
  saved.numbers("contact/pull_eigenvalue", pull_eigenvalue_);
  saved.list("contact/left_nodes", left_);
  if (!saved.restores()) return;
  has_begun_ = true;
  mobility_.update(motion.time);
  kinematics_.hold(mobility_.free_directions());
  rules_.activate(motion.time, times_.is_active(motion.time));
  kinematics_.move_nodes(motion);
  kinematics_.bound_all();
  kinematics_.watch(detection_.faces_with_candidates());
}

}  // namespace contactsim

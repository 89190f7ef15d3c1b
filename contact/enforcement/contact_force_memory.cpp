// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "contact/enforcement/contact_force.hpp"
#include "contact/enforcement/explicit_points.hpp"
#include "core/base/digest.hpp"
#include "core/base/state_archive.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

/// But for the formulation: NODE_FACE of load steps has no nodes that meet faces one by one.
bool are_like(const SurfacePair& a, const SurfacePair& b) {
  return std::minmax(a.first, a.second) == std::minmax(b.first, b.second) && a.behavior == b.behavior &&
         a.separates == b.separates && a.gap == b.gap && a.law->type == b.law->type &&
         (!row_of(*a.law).holds_at_start || a.formulation == b.formulation);
}

}  // namespace

/// Whether both are of load steps, or of explicit dynamics.
bool ContactForce::goes_on_as(const ContactForce& earlier) const {
  return setup_.is_static() == earlier.setup_.is_static();
}

bool ContactForce::is_like(const ContactForce& earlier) const {
  const SurfacePairs &pairs = setup_.contact.pairs, &others = earlier.setup_.contact.pairs;
  const auto has_same_enforcement = [](const SurfacePair& a, const SurfacePair& b) {
    return a.enforcement == b.enforcement;
  };
  return std::ranges::equal(pairs, others, are_like) &&
         (!goes_on_as(earlier) || std::ranges::equal(pairs, others, has_same_enforcement)) &&
         surfaces_digest() == earlier.surfaces_digest();
}

void ContactForce::take_over(ContactForce& earlier, const Motion& ended, const Motion& motion, double until) {
  if (goes_on_as(earlier)) {
    StateArchive saves;
    earlier.archive(motion, saves);
    const SavedState memory = saves.take();
    StateArchive restores(memory);
    balance_.go_on();
    return archive(motion, restores);
  }
  if (!setup_.is_static()) {
    // Found anew: where that procedure went on from its last state alone there are none.
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, ended.coordinates.cols());
    earlier.begin_trials(ended);
    earlier.try_forces(ended, forces, nullptr);
    balance_.begin_pressed(explicit_points_of(earlier.trial_->points, setup_.contact.pairs, contact_mesh_));
    preload_forces_.take_over(earlier.trial_->assembler, until);
  }
  kinematics_.set_offsets(earlier.kinematics_.offsets());
  constrained_ = earlier.constrained_;
  detection_.begin_with_ties(earlier.ties());
}

/// Holds what contact pressed with before and does not by itself.
///   context  of pairs whose momentum is balanced, where there are any: their points have been added
void ContactForce::begin_preload_forces(const ContactStepContext& context, double time) {
  ContactAssembler now(contact_mesh_.n_nodes(), setup_.contact.pairs.size(), false,
                       !assembler_.moments().empty());
  for (const ContactPoint& point : points_) now.add_forces(point);
  std::vector<ConstraintForces> held = constraint_forces_;
  if (context.balances) {
    for (const ContactPoint& point : balance_.begun_points()) now.add_forces(point);
    ContactStepContext trial = context;
    trial.is_trial = true;
    detection_.detect_constraints(trial, constrained_, held);
  }
  for (const ConstraintForces& one : held) now.add(one.constraint, one.forces);
  preload_forces_.begin(now, time, context.balances);
}

std::uint64_t ContactForce::surfaces_digest() const {
  Digest digest;
  for (const ContactFace& face : contact_mesh_.faces)
    digest.add_values(std::span<const ContactNodeIndex>(face.corners));
  digest.add_values(std::span<const NodeIndex>(contact_mesh_.mesh_nodes));
  digest.add_values(std::span<const FaceIndex>(contact_mesh_.first_face));
  digest.add_values(std::span<const SurfaceNodeIndex>(contact_mesh_.first_node));
  for (const ContactEdge& edge : contact_mesh_.edges)
    digest.add_values(std::span<const ContactNodeIndex>(edge.nodes));
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
  recovery_energy_.archive(saved);
  preload_forces_.archive(saved);
  multipliers_.archive("contact/multipliers", saved);
  held_slips_.archive("contact/held_slips", saved);
  stabilization_.archive(contact_mesh_.n_nodes(), saved);
  step_limit_.archive(saved);
  saved.numbers("contact/stored_at_start", stored_at_start_);
  saved.numbers("contact/start_step", start_step_);
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

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/pair_histories.hpp"

#include <algorithm>
#include <limits>

#include "core/base/state_archive.hpp"

namespace contactsim {

void PairHistories::begin(const ContactAssembler& assembler) {
  for (const PairIndex i : indices(histories_)) histories_[i].stored_at_start = assembler.pairs()[i].stored;
}

double PairHistories::add(const ContactAssembler& assembler, const GapOffsets& offsets, double dt) {
  const auto steps = assembler.pairs();
  double supplied = 0.0;
  for (const PairIndex i : indices(steps)) {
    const PairStep& step = steps[i];
    PairHistory& history = histories_[i];
    history.work += step.stored - stored_[i] + step.dissipated + step.damped;
    history.impact += step.impact;
    stored_[i] = step.stored;
    const double ramped = 0.5 * (ramp_energy_[i] + step.ramp_energy) * offsets.ramp_progress(i);
    history.ramped += ramped;
    supplied += ramped;
    ramp_energy_[i] = step.ramp_energy;
    history.taken = assembler.taken()[i];
    if (step.penetration > history.deepest) {
      history.deepest = step.penetration;
      history.deepest_share = step.penetration_share;
    }
    if (!step.touches) continue;
    history.contact_time += dt;
    history.peak_force = std::max(history.peak_force, step.force.norm());
    history.impulse -= dt * step.force;
    history.friction_work += step.dissipated;
  }
  return supplied;
}

void PairHistories::add_lost(std::span<const LostContact> lost, const PairRules& rules,
                             const ContactMesh& contact_mesh, double time) {
  for (const LostContact& one : lost) {
    if (!rules[one.pair].is_active) continue;
    PairHistory& history = histories_[one.pair];
    if (history.n_lost++ > 0) continue;
    history.lost_node = contact_mesh.mesh_nodes[one.node];
    history.lost_time = time;
    history.lost_depth = one.depth;
  }
}

void PairHistories::note_slide(const ContactPoint& point, const ContactMesh& contact_mesh) {
  if (!point.touches()) return;
  PairHistory& history = histories_[point.pair];
  const auto note = [&](const ContactPointSide& side, const ContactPointSide& other) {
    const double beyond = -side.weights.minCoeff();
    if (!(beyond > history.slid_share)) return;
    history.slid_share = beyond;
    history.slid_node = contact_mesh.mesh_nodes[other.nodes[0]];
  };
  note(point.second, point.first);
  note(point.first, point.second);
}

void PairHistories::add_released(std::span<const ReleasedPartner<FaceIndex>> faces,
                                 std::span<const ReleasedPartner<SurfaceNodeIndex>> rows,
                                 const ContactMesh& contact_mesh) {
  const auto add = [&](const auto& released, ContactNodeIndex node) {
    PairHistory& history = histories_[released.pair];
    if (history.n_released++ == 0) history.released_node = contact_mesh.mesh_nodes[node];
  };
  for (const auto& face : faces) add(face, contact_mesh.faces[face.entity].corners[0]);
  for (const auto& row : rows) add(row, contact_mesh.surface_nodes[row.entity].node);
}

void PairHistories::forget_stored(std::span<const ContactPoint> points,
                                  std::span<const ConstraintForces> constraints) {
  std::fill(stored_.begin(), stored_.end(), 0.0);
  for (const ContactPoint& point : points) {
    if (point.touches()) stored_[point.pair] += point.stored();
  }
  for (const ConstraintForces& held : constraints) stored_[held.constraint.pair] += held.forces.stored;
}

IndexedSpan<PairIndex, const double> PairHistories::update_available_energy(
    const PairRules& rules, const ContactAssembler& assembler) {
  available_.assign(histories_.size(), std::numeric_limits<double>::quiet_NaN());
  for (const PairIndex i : indices(available_)) {
    const PairRule& rule = rules[i];
    const bool only_pushes = rule.interface_law == nullptr || rule.interface_law->only_presses();
    const bool is_simple =
        rule.law == ContactLaw::sliding && only_pushes && !rule.far && !rule.model.is_variant();
    // What a ramp puts in is known after the forces only.
    const bool is_ramped = rules.gap_offsets().ramp_progress(i) > 0.0;
    if (!is_simple || rule.is_balanced || is_ramped) continue;
    const double lost = histories_[i].work - stored_[i];
    available_[i] = histories_[i].stored_at_start + histories_[i].ramped + assembler.taken()[i] - lost;
    min_energy_[i] = std::min(min_energy_[i], available_[i]);
  }
  return available_;
}

void PairHistories::archive(StateArchive& saved) {
  saved.fixed_rows("contact/pairs/history", histories_, [](PairHistory& history, RowNumbers& row) {
    row(history.contact_time, history.peak_force, history.impulse, history.work, history.friction_work,
        history.impact, history.deepest, history.deepest_share, history.taken, history.stored_at_start,
        history.ramped, history.slid_share, history.slid_node, history.n_released, history.released_node,
        history.n_lost, history.lost_node, history.lost_time, history.lost_depth);
  });
  saved.fixed("contact/pairs/stored", std::span(stored_));
  saved.fixed("contact/pairs/ramp_energy", std::span(ramp_energy_));
  saved.fixed("contact/pairs/least_energy", std::span(min_energy_));
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/enforcement/contact_assembler.hpp"
#include "contact/enforcement/pair_history.hpp"
#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/interface_constraint.hpp"
#include "contact/formulations/start_partners.hpp"
#include "contact/interface_laws/pair_rules.hpp"

namespace contactsim {

/// What every pair has done in a run, and the energy that it may give back.
class PairHistories {
 public:
  explicit PairHistories(std::size_t n_pairs)
      : histories_(n_pairs), min_energy_(n_pairs, 0.0), stored_(n_pairs, 0.0), ramp_energy_(n_pairs, 0.0) {}

  IndexedSpan<PairIndex, const PairHistory> all() const { return histories_; }

  /// Takes what the pairs store before the first step.
  void begin(const ContactAssembler& assembler);
  /// Adds a step.
  ///   dt  of the step [time]
  /// Returns the work of overlaps that are ramped [energy].
  double add(const ContactAssembler& assembler, const GapOffsets& offsets, double dt);
  /// Adds contacts that ended though their sides did not part; those that a pair's period ends are not among
  /// them.
  void add_lost(std::span<const LostContact> lost, const PairRules& rules, const ContactMesh& contact_mesh,
                double time);
  /// Notes how far a contact point of a pair that slides infinitesimally is beyond its face of the start.
  void note_slide(const ContactPoint& point, const ContactMesh& contact_mesh);
  /// Adds what deaths have released from its faces of the start: faces, or surface nodes.
  void add_released(std::span<const ReleasedPartner<FaceIndex>> faces,
                    std::span<const ReleasedPartner<SurfaceNodeIndex>> rows, const ContactMesh& contact_mesh);
  /// What springs stored that deaths have removed is not given back.
  ///   points, constraints  that are left of the last step
  void forget_stored(std::span<const ContactPoint> points, std::span<const ConstraintForces> constraints);

  /// What each pair had at the start and has taken, without what it has lost. Laws that pull, ties and what
  /// decays keep books of their own. NaN of pairs without a limit [energy]
  IndexedSpan<PairIndex, const double> update_available_energy(const PairRules& rules,
                                                               const ContactAssembler& assembler);
  /// The least of it so far, <= 0 [energy]
  IndexedSpan<PairIndex, const double> min_energy() const { return min_energy_; }

  void archive(StateArchive& saved);

 private:
  IndexedVector<PairIndex, PairHistory> histories_;
  IndexedVector<PairIndex, double> available_;    // scratch [energy]
  IndexedVector<PairIndex, double> min_energy_;   // [energy]
  IndexedVector<PairIndex, double> stored_;       // of the last step [energy]
  IndexedVector<PairIndex, double> ramp_energy_;  // PairStep::ramp_energy of the last step
};

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/enforcement/contact_assembler.hpp"
#include "contact/enforcement/contact_mobility.hpp"
#include "contact/interface_laws/pair_rules.hpp"

namespace contactsim {

/// The springs of contact in a step, and what they are between.
struct StepSprings {
  const ContactKinematics& kinematics;
  const PairRules& rules;
  std::span<const ContactPoint> points;
  std::span<const ConstraintForces> held;
  IndexedSpan<PairIndex, const PairStep> pairs;
};

/// How much contact lowers the stable step.
class ContactStepLimit {
 public:
  /// The stable step that the penalty leaves; infinite where nothing touches [time].
  ///   stable_step  of the elements [time]
  double find(double stable_step, const StepSprings& springs, ContactMobility& mobility);
  /// Has the springs of laws that pull where momentum is balanced limit the step after the coming one.
  void note_pulls(const StepSprings& springs, ContactMobility& mobility) {
    pull_eigenvalue_ = largest_eigenvalue(springs, mobility);
  }
  /// The largest share of its stable step that the run has lost so far [1].
  double lost_share() const { return lost_share_; }
  void archive(StateArchive& saved);

 private:
  double largest_eigenvalue(const StepSprings& springs, ContactMobility& mobility);

  double lost_share_ = 0.0;
  double pull_eigenvalue_ = 0.0;                       // in the last step [1/time^2]
  IndexedVector<PairIndex, std::uint8_t> slips_;       // scratch: has springs along the surface
  IndexedVector<SurfaceIndex, double> surface_rates_;  // scratch
};

}  // namespace contactsim

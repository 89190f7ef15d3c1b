// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/formulations/interface_constraint.hpp"

namespace contactsim {

class StateArchive;

/// The pull of a hold that has failed, as it decays: a straight line to nothing over some steps.
struct DecayingConstraint : InterfaceConstraint {
  CornerVectors forces = CornerVectors::Zero();  ///< at failure, in axes of the second face [force]
  double stored = 0.0;                           ///< at failure [energy]
  std::int64_t n_steps = 1, n_done = 0;

  bool is_over() const { return n_done >= n_steps; }
};

/// A constraint that has failed with these forces.
DecayingConstraint make_decaying(const InterfaceConstraint& constraint, const CornerForces& at_failure,
                                 const CornerVectors& x, std::int64_t n_steps);
/// Its forces now.
CornerForces find_decaying_forces(const DecayingConstraint& constraint, const CornerVectors& x);

/// What ties and bonds leave behind that have failed. Of all formulations together: forces are in the order
/// of the failures.
class DecayingConstraints {
 public:
  /// Takes a constraint over that has failed with these forces.
  void add(const ContactStepContext& context, const ConstraintForces& failed);
  /// Goes on by a step, in which what the constraints held and what is done on them is lost. Appends the
  /// forces; what is over then is left out afterwards.
  void step(const ContactStepContext& context, std::vector<ConstraintForces>& found);
  /// Ends what is left of pairs whose model has just changed.
  void end_changed(const PairRules& rules);
  void remap(const ContactRemap& remap) { keep_constraints(remap, constraints_); }
  void archive(StateArchive& saved);

  std::span<const DecayingConstraint> constraints() const { return constraints_; }

 private:
  std::vector<DecayingConstraint> constraints_;
};

}  // namespace contactsim

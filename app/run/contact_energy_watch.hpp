// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/enforcement/contact_force.hpp"
#include "core/base/diagnostics.hpp"
#include "core/dynamics/state.hpp"

namespace contactsim {

class StateArchive;

/// What pairs without springs gave out to come out of overlaps of the mesh, or of what the procedure before
/// had pressed [energy].
///   begins_pressed  by contact of the procedure before
double given_out_by_overlaps(const ContactForce& force, bool begins_pressed);

/// Watches the energy that contact gives out though nothing had put it in.
class ContactEnergyWatch {
 public:
  /// Looks at the state after a step, and remembers the most. Throws SolveError naming the pair when contact
  /// has for some steps given out more energy from nowhere than all that was put into the model.
  ///   of_overlaps  given_out_by_overlaps()
  void step(const ContactForce& force, double of_overlaps, const ContactModel& contact, const Model& model,
            const State& state);
  /// Warns of the most, "contact-energy", where it is worth a word, and names the pair.
  void warn(const ContactModel& contact, const Energies& energies, Diagnostics& warnings) const;
  void archive(StateArchive& saved);

 private:
  int n_runaway_steps_ = 0;  // on end
  double most_ = 0.0;        // that contact has given out from nowhere so far [energy]
  PairIndex culprit_ = {};   // that had made most of it
  double by_culprit_ = 0.0;  // [energy]
};

}  // namespace contactsim

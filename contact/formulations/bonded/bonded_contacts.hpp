// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/formulations/bonded/bonds.hpp"
#include "contact/formulations/contact_formulation.hpp"

namespace contactsim {

/// The bonds of spring welds, cohesive zones and threaded joints. They act by their own forces where momentum
/// is balanced, too. The forces of one that has failed decay.
/// An InterfaceFormulation.
class BondedContacts {
 public:
  void find_candidates(const ContactStepContext& context, const NearCandidates& near, bool only_changed,
                       ConstrainedPairs& constrained);
  std::span<const Bond> constraints() const { return bonds_; }

  void detect(const ContactStepContext& context, std::vector<ConstraintForces>& found) const;
  /// Takes over what the laws remember.
  void update(const ContactStepContext& context, std::span<const ConstraintForces> found,
              ConstrainedPairs& constrained, DecayingConstraints& decaying);

  void remap(const ContactRemap& remap) { keep_constraints(remap, bonds_); }
  void archive(StateArchive& saved);

 private:
  std::vector<Bond> bonds_;
};

}  // namespace contactsim

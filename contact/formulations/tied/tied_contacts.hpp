// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/formulations/contact_formulation.hpp"
#include "contact/formulations/tied/make_ties.hpp"

namespace contactsim {

/// The ties of tied, glued and welded pairs. A weld that has failed leaves its sides to contact at once; its
/// forces decay.
/// An InterfaceFormulation.
class TiedContacts {
 public:
  /// Has pairs that are tied or glued begin with what load steps before held, by the stiffness of now and
  /// with the forces of then, and nothing tied anew. To be called before find_candidates().
  void begin_with(std::span<const Tie> ties);
  void find_candidates(const ContactStepContext& context, const NearCandidates& near, bool only_changed,
                       ConstrainedPairs& constrained);
  std::span<const Tie> constraints() const { return ties_; }

  /// Where momentum is balanced, once that has found the forces of the points.
  void detect(const ContactStepContext& context, std::vector<ConstraintForces>& found) const;
  void update(const ContactStepContext& context, std::span<const ConstraintForces> found,
              ConstrainedPairs& constrained, DecayingConstraints& decaying);

  /// Ties what has touched under a GLUED MODEL, from the next step on, as deep as it is now. What its springs
  /// hold stays in them: the tie has no way to give it back.
  void glue(const ContactStepContext& context, const ContactPoint& contact_point,
            ConstrainedPairs& constrained);
  /// Calls take(tie) for those whose forces momentum balance has to find.
  template <class Take>
  void visit_balanced(const ContactStepContext& context, const Take& take) {
    for (Tie& tie : ties_) {
      if (context.enforces(rule_of(context, tie))) take(tie);
    }
  }

  void remap(const ContactRemap& remap) { keep_constraints(remap, ties_); }
  void archive(StateArchive& saved);

 private:
  std::vector<Tie> ties_;
  bool takes_over_ = false;  // of load steps before
};

}  // namespace contactsim

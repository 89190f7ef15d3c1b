// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/enforcement/contact_assembler.hpp"
#include "contact/formulations/bonded/bonds.hpp"
#include "contact/formulations/contact_step_context.hpp"
#include "contact/mesh/pair_lists.hpp"

namespace contactsim {

class MomentumBalance;

/// What may be near each other.
struct NearCandidates {
  const PairLists& face_partners;
  const PairLists& node_faces;
  double size_share = 0.0;  ///< automatic tolerance over the square root of a face's area [1]
};

/// A constraint that held in a step, and by which forces.
struct ConstraintForces {
  InterfaceConstraint constraint;
  TieForces forces;
};

/// All interface constraints: ties of tied, glued and welded pairs, bonds of spring welds, cohesive
/// zones and threaded joints, and what decays once a weld or a bond has failed. A weld that has failed leaves
/// its sides to contact at once.
class InterfaceConstraints {
 public:
  /// Ties and bonds what is near: of all pairs, or of those whose model has just changed; the latter lose
  /// what they had.
  void begin(const ContactStepContext& context, const NearCandidates& candidates,
             ConstrainedPairs& constrained);
  void renew(const ContactStepContext& context, const NearCandidates& candidates,
             ConstrainedPairs& constrained);
  /// Goes over to other faces and nodes: what held a side that is gone is over.
  void remap(const ContactRemap& remap);
  /// Ties what has touched under a GLUED MODEL, from the next step on, as deep as it is now. What its springs
  /// hold stays in them: the tie has no way to give it back.
  void glue(const ContactStepContext& context, const ContactPoint& contact_point,
            ConstrainedPairs& constrained);

  /// Takes a step: adds all forces, ends what has failed.
  void step(const ContactStepContext& context, ConstrainedPairs& constrained, ContactAssembler& assembler);
  /// The ties of pairs that are enforced by momentum balance: gives them to it, and takes their forces from
  /// it, ending what has failed.
  void add_balanced(const ContactStepContext& context, MomentumBalance& balance);
  void take_balanced(const ContactStepContext& context, const MomentumBalance& balance,
                     ConstrainedPairs& constrained, ContactAssembler& assembler);
  /// What held in the last step, with its forces.
  std::span<const ConstraintForces> forces() const { return forces_; }
  void begin_step() { forces_.clear(); }

  std::span<const Tie> ties() const { return ties_; }
  std::span<const Bond> bonds() const { return bonds_; }
  std::span<const DecayingConstraint> fading() const { return fading_; }
  std::size_t size() const { return ties_.size() + bonds_.size() + fading_.size(); }
  /// Ties first, then bonds, then what decays.
  const InterfaceConstraint& operator[](std::size_t i) const;

  void archive(StateArchive& saved);

 private:
  void make(const ContactStepContext& context, const NearCandidates& candidates, bool only_changed,
            ConstrainedPairs& constrained);
  void step_decaying(const ContactStepContext& context, ContactAssembler& assembler);
  void step_ties(const ContactStepContext& context, ConstrainedPairs& constrained,
                 ContactAssembler& assembler);
  template <class FindForces>
  void take_ties(const ContactStepContext& context, bool is_balanced, const FindForces& find_forces,
                 ConstrainedPairs& constrained, ContactAssembler& assembler);
  void step_bonds(const ContactStepContext& context, ContactAssembler& assembler);

  void add(const InterfaceConstraint& constraint, const TieForces& forces, ContactAssembler& assembler);

  std::vector<ConstraintForces> forces_;
  std::vector<Tie> ties_;
  std::vector<Bond> bonds_;
  std::vector<DecayingConstraint> fading_;
};

}  // namespace contactsim

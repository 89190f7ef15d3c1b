// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/bonds.hpp"
#include "contact/contact_scene.hpp"
#include "contact/contact_sums.hpp"
#include "contact/pair_lists.hpp"

namespace contactsim {

class MomentumBalance;

/// What may be near each other.
struct NearCandidates {
  const PairLists& face_partners;
  const PairLists& node_faces;
  double size_share = 0.0;  ///< automatic tolerance over the square root of a face's area [1]
};

/// A place that was held in a step, and by which forces.
struct HeldForces {
  HeldPlace place;
  TieForces forces;
};

/// All that holds places together: ties of tied, glued and welded pairs, bonds of spring welds, cohesive
/// zones and threaded joints, and what fades once a weld or a bond has failed. A weld that has failed leaves
/// its place to contact at once.
class HeldPlaces {
 public:
  /// Ties and bonds what is near: of all pairs, or of those whose model has just changed; the latter lose
  /// what they had.
  void begin(const ContactScene& scene, const NearCandidates& candidates, GluedPlaces& glued);
  void renew(const ContactScene& scene, const NearCandidates& candidates, GluedPlaces& glued);
  /// Goes over to other faces and nodes: what held a side that is gone is over.
  void renumber(const ContactRenumbering& places);
  /// Ties what has touched under a GLUED MODEL, from the next step on, as deep as it is now. What its springs
  /// hold stays in them: the tie has no way to give it back.
  void glue(const ContactScene& scene, const ContactRecord& record, GluedPlaces& glued);

  /// Takes a step: adds all forces, ends what has failed.
  void step(const ContactScene& scene, GluedPlaces& glued, ContactSums& sums);
  /// The ties of pairs that are enforced by momentum balance: gives them to it, and takes their forces from
  /// it, ending what has failed.
  void add_balanced(const ContactScene& scene, MomentumBalance& balance);
  void take_balanced(const ContactScene& scene, const MomentumBalance& balance, GluedPlaces& glued,
                     ContactSums& sums);
  /// What held in the last step, with its forces.
  std::span<const HeldForces> forces() const { return forces_; }
  void begin_step() { forces_.clear(); }

  std::span<const Tie> ties() const { return ties_; }
  std::span<const Bond> bonds() const { return bonds_; }
  std::span<const FadingPlace> fading() const { return fading_; }
  std::size_t size() const { return ties_.size() + bonds_.size() + fading_.size(); }
  /// Ties first, then bonds, then what fades.
  const HeldPlace& operator[](std::size_t i) const;

  void archive(StateArchive& saved);

 private:
  void make(const ContactScene& scene, const NearCandidates& candidates, bool only_changed,
            GluedPlaces& glued);
  void step_fading(const ContactScene& scene, ContactSums& sums);
  void step_ties(const ContactScene& scene, GluedPlaces& glued, ContactSums& sums);
  template <class FindForces>
  void take_ties(const ContactScene& scene, bool is_balanced, const FindForces& find_forces,
                 GluedPlaces& glued, ContactSums& sums);
  void step_bonds(const ContactScene& scene, ContactSums& sums);

  void add(const HeldPlace& place, const TieForces& forces, ContactSums& sums);

  std::vector<HeldForces> forces_;
  std::vector<Tie> ties_;
  std::vector<Bond> bonds_;
  std::vector<FadingPlace> fading_;
};

/// Marks the faces and nodes of HYBRID pairs that are close to the other side.
void mark_close_places(const ContactScene& scene, const NearCandidates& candidates, PairRules& rules);

}  // namespace contactsim

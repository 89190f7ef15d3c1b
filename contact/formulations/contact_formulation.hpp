// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/contact_step_context.hpp"
#include "contact/formulations/decaying_constraints.hpp"
#include "contact/formulations/near_pairs.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/mesh/contact_remap.hpp"
#include "contact/search/contact_search.hpp"

namespace contactsim {

class StateArchive;

/// What formulations are made of. All must outlive them.
struct FormulationSetup {
  const ContactMesh& contact_mesh;
  const ContactModel& contact;
  const PairRules& rules;
};

/// Rows of candidates [begin, end) that are worked on as one piece: begin is a multiple of rows_per_chunk.
struct CandidateRows {
  std::size_t begin = 0, end = 0;

  template <class AnIndex>
  IndexRange<AnIndex> indices() const {
    return {{static_cast<std::uint32_t>(begin)}, {static_cast<std::uint32_t>(end)}};
  }
};

/// What all formulations share.
///   remap(remap)    goes over to other faces, nodes and edges, which stand where those before stood already
///   archive(saved)  saves or restores what is remembered between steps
template <class F>
concept FormulationBase = requires(F formulation, const ContactRemap& remap, StateArchive& saved) {
  formulation.remap(remap);
  formulation.archive(saved);
};

/// One way in which sides meet, and push each other apart: faces and faces, nodes and faces, edges and edges,
/// nodes and planes. Made of a FormulationSetup.
///   find_candidates(search, kinematics, motion)
///       the broad phase; what is remembered of pairs that were candidates before stays
///   n_rows(), n_candidates()
///       rows of candidates, and how many there are in all
///   watch(is_watched)
///       marks the faces of which bounds are needed until the next search
///   begin_step()
///       what was remembered becomes that of the last step
///   undo_begin_step()
///       the opposite, before the first update(): a search may follow
///   detect(context, rows, points)
///       the narrow phase: appends the contact points of the pairs that the context enforces, row by row.
///       Changes nothing; rows may be shared among threads
///   update(context, rows, points)
///       takes over what detect() has found in some rows into what is remembered. Rows come in order, while
///       others are still detected
///   find_lost(rules, lost)
///       appends the contacts of the step before the last one that ended though they were deep
/// It may also have
///   begin_detection(context)
///       what all rows of detect() read
///   complete(context, points)
///       changes points that depend on each other, once all are detected
///   mark_close(context, size_share, rules)
///       marks what of HYBRID pairs is close to the other side; size_share is the automatic CAPTURE TOLERANCE
///       over the size of a side [1]
///   n_close(), watch_close(is_watched), forget_close()
///       of what renew_close of CandidateUse has found: as n_candidates() and watch(); gives it back
///   add_start_gaps(context, gaps)
///       before the first step: appends the gaps of pairs that have to know them
template <class F>
concept PointFormulation = FormulationBase<F> && std::constructible_from<F, const FormulationSetup&> &&
    requires(F formulation, const F& is, ContactSearch& search, const ContactKinematics& kinematics,
             const Motion& motion, const ContactStepContext& context,
             IndexedVector<FaceIndex, std::uint8_t>& is_watched, std::vector<ContactPoint>& points,
             std::span<const ContactPoint> found, std::vector<LostContact>& lost) {
  formulation.find_candidates(search, kinematics, motion);
  { is.n_rows() } -> std::same_as<std::size_t>;
  { is.n_candidates() } -> std::same_as<std::size_t>;
  is.watch(is_watched);
  formulation.begin_step();
  formulation.undo_begin_step();
  is.detect(context, CandidateRows{}, points);
  formulation.update(context, CandidateRows{}, found);
  is.find_lost(context.rules, lost);
};

/// One way in which sides are held together, until that fails: ties and bonds. Made of nothing.
///   find_candidates(context, near, only_changed, constrained)
///       holds what is near: of all pairs, or of those whose model has just changed, which lose what they
///       had. What contact has to leave alone goes into `constrained`
///   constraints()
///       what holds now, a range of InterfaceConstraints
///   detect(context, found)
///       appends the forces of what the context enforces, where the sides are. Changes nothing
///   update(context, found, constrained, decaying)
///       takes over what detect() has found into what is remembered: damage, failure
/// It may also have
///   glue(context, point, constrained)
///       holds what has touched under a GLUED MODEL, from the next step on
///   visit_balanced(context, take)
///       takes those whose forces momentum balance has to find before detect()
template <class F>
concept InterfaceFormulation = FormulationBase<F> && std::default_initializable<F> &&
    requires(F formulation, const F& is, const ContactStepContext& context, const NearCandidates& near,
             ConstrainedPairs& constrained, std::vector<ConstraintForces>& forces,
             std::span<const ConstraintForces> found, DecayingConstraints& decaying) {
  formulation.find_candidates(context, near, true, constrained);
  is.constraints();
  is.detect(context, forces);
  formulation.update(context, found, constrained, decaying);
};

/// What stands in the list of formulations.
template <class F>
concept ContactFormulation = PointFormulation<F> || InterfaceFormulation<F>;

}  // namespace contactsim

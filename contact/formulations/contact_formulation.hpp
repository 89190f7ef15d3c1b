// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/contact_step_context.hpp"
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
};

/// One way in which sides meet: faces and faces, nodes and faces, edges and edges, nodes and planes. Made of
/// a FormulationSetup.
///   find_candidates(search, kinematics, motion)  the broad phase; what is remembered of pairs that were
///                                  candidates before stays
///   n_rows(), n_candidates()       rows of candidates, and how many there are in all
///   watch(is_watched)              marks the faces of which bounds are needed until the next search
///   [n_faces] begin_step()                   what was remembered becomes that of the last step
///   detect(context, rows, points)  the narrow phase: appends the contact points of the pairs that the
///   context
///                                  enforces, row by row. Changes nothing; rows may be shared among threads
///   update(context, rows, points)  takes over what detect() has found in some rows into what is remembered.
///                                  Rows come in order, while others are still detected
///   find_lost(rules, lost)         appends the contacts of the step before the last one that ended though
///                                  they were deep
///   remap(remap)                   goes over to other faces, nodes and edges, which stand where those of the
///                                  setup stood already
///   archive(saved)                 saves or restores what is remembered between steps
/// A formulation may also have
///   complete(context, points)      changes points that depend on each other, once all are detected
///   mark_close(context, size_share, rules)  marks what of HYBRID pairs is close to the other side;
///   size_share
///                                  is the automatic CAPTURE TOLERANCE over the size of a side [1]
template <class F>
concept ContactFormulation = std::constructible_from<F, const FormulationSetup&> &&
    requires(F formulation, const F& is, ContactSearch& search, const ContactKinematics& kinematics,
             const Motion& motion, const ContactStepContext& context, std::vector<std::uint8_t>& is_watched,
             std::vector<ContactPoint>& points, std::span<const ContactPoint> found,
             std::vector<LostContact>& lost, const ContactRemap& remap, StateArchive& saved) {
  formulation.find_candidates(search, kinematics, motion);
  { is.n_rows() } -> std::same_as<std::size_t>;
  { is.n_candidates() } -> std::same_as<std::size_t>;
  is.watch(is_watched);
  formulation.begin_step();
  is.detect(context, CandidateRows{}, points);
  formulation.update(context, CandidateRows{}, found);
  is.find_lost(context.rules, lost);
  formulation.remap(remap);
  formulation.archive(saved);
};

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/interpenetration_warnings.hpp"

#include <fmt/format.h>

#include "app/run/start_overlap.hpp"
#include "core/base/pluralize.hpp"

namespace contactsim {

void warn_of_interpenetration(const ContactForce& force, const ContactModel& contact, const Mesh& mesh,
                              IndexedSpan<PairIndex, const Interpenetration> found, Diagnostics& warnings) {
  // Faces meet by areas: below a coarse face a node may lie in by less while the mean gap is closed.
  constexpr double worrying = 0.2;  // of the thickness
  const auto id = [&](std::uint32_t node) { return mesh.node_id(NodeIndex{node}); };
  for (const PairIndex i : indices(found)) {
    const Interpenetration& one = found[i];
    const SurfacePair& pair = contact.pairs[i];
    if (one.share > worrying && one.depth > force.histories()[i].deepest)
      warnings.add_warning(
          "interpenetration", pair.location,
          fmt::format(
              "the bodies of {} lie in each other at time {:.6g}: node {} is {:.3g} inside the other, "
              "{:.0f} % of the thickness ({} there); contact does not hold them apart",
              names_of(contact, i), one.time, id(one.node), one.depth, 100.0 * one.share,
              pluralize(one.n_nodes, "node")),
          "smaller steps, finer faces or the other CONSTRAINT FORMULATION may");
    if (one.n_crossed > 0)
      warnings.add_warning(
          "passed-through", pair.location,
          fmt::format(
              "{}: node {} has gone through the mid surface of the other by time {:.6g} ({} in the run)",
              names_of(contact, i), id(one.crossed_node), one.crossed_time,
              pluralize(one.n_crossed, "passage")),
          "");
  }
}

}  // namespace contactsim

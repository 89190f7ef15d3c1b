// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/pair_history_warnings.hpp"

#include <fmt/format.h>

#include "app/run/start_overlap.hpp"
#include "core/base/pluralize.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

void warn_of_penetration(IndexedSpan<PairIndex, const PairHistory> histories, const ContactModel& contact,
                         Diagnostics& warnings) {
  constexpr double worrying = 0.1;  // of the thickness
  for (const PairIndex i : indices(histories)) {
    if (!(histories[i].deepest_share > worrying)) continue;
    const SurfacePair& pair = contact.pairs[i];
    const bool is_penalty = pair.enforcement == Enforcement::penalty,
               is_soft = row_of(*pair.law).has_pressure;
    warnings.add_warning(
        "contact-penetration", pair.location,
        fmt::format("{} have penetrated each other by {:.3g}, {:.0f} % of the thickness behind them",
                    names_of(contact, i), histories[i].deepest, 100.0 * histories[i].deepest_share),
        is_soft      ? "the pressure of its friction model lets them"
        : is_penalty ? "ENFORCEMENT = MOMENTUM_BALANCE lets nothing through"
                     : "");
  }
}

void warn_of_lost(IndexedSpan<PairIndex, const PairHistory> histories, const ContactModel& contact,
                  const Mesh& mesh, Diagnostics& warnings) {
  for (const PairIndex i : indices(histories)) {
    const PairHistory& history = histories[i];
    if (history.n_lost == 0) continue;
    const SurfacePair& pair = contact.pairs[i];
    const auto name = [&](SurfaceIndex surface) { return contact.surfaces.surfaces[surface].name; };
    const NodeIndex node = history.lost_node;
    warnings.add_warning(
        "contact-lost", {},
        fmt::format(
            "contact of {} and {} ended at time {:.6g} at node {}, {:.3g} deep: one side has got past "
            "the other ({} in the run)",
            name(pair.first), name(pair.second), history.lost_time, mesh.node_id(node), history.lost_depth,
            pluralize(history.n_lost, "place")));
  }
}

}  // namespace

void warn_of_depths(IndexedSpan<PairIndex, const PairHistory> histories, const ContactModel& contact,
                    const Mesh& mesh, Diagnostics& warnings) {
  warn_of_lost(histories, contact, mesh, warnings);
  warn_of_penetration(histories, contact, warnings);
}

void warn_of_small_sliding(IndexedSpan<PairIndex, const PairHistory> histories, const ContactModel& contact,
                           const Mesh& mesh, Diagnostics& warnings) {
  constexpr double worth_telling = 0.5;  // of a face
  const auto id = [&](NodeIndex node) { return mesh.node_id(node); };
  for (const PairIndex i : indices(histories)) {
    const PairHistory& history = histories[i];
    const SurfacePair& pair = contact.pairs[i];
    if (history.slid_share > worth_telling)
      warnings.add_warning(
          "slid-off-partner", pair.location,
          fmt::format(
              "{} have slid off their faces of the start, at node {} by {:.2g} of a face; the plane of "
              "that face goes on there",
              names_of(contact, i), id(history.slid_node), history.slid_share),
          "INTERACTION BEHAVIOR = SLIDING follows the surface");
    if (history.n_released > 0)
      warnings.add_warning(
          "start-face-lost", pair.location,
          fmt::format(
              "{}: {} lost their faces of the start to element death, the first at node {}; they slide "
              "since",
              names_of(contact, i), pluralize(history.n_released, "place"), id(history.released_node)),
          "");
  }
}

}  // namespace contactsim

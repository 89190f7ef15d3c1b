// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/death_report.hpp"

#include <fmt/format.h>

#include "app/reports/surface_report.hpp"
#include "app/reports/text_table.hpp"
#include "core/base/pluralize.hpp"

namespace contactsim {

namespace {

std::string format_counts(const DeathTally& tally) {
  SurfaceChange sum;
  for (const SurfaceChange& change : tally.changes) {
    sum.faces_gained += change.faces_gained;
    sum.faces_lost += change.faces_lost;
  }
  return fmt::format("; contact gains {}, loses {}, has {}\n", pluralize(sum.faces_gained, "face"),
                     pluralize(sum.faces_lost, "face"), pluralize(tally.n_free, "free node"));
}

std::string format_changes(const DeathTally& tally, const ContactModel& contact) {
  TextTable table(
      2, 1,
      {name_column("surface", 28), {"gained", 9}, {"lost", 9}, {"faces", 9}, {"lost", 9}, {"lofted", 9}});
  for (const SurfaceIndex i : indices(tally.changes)) {
    const SurfaceChange& change = tally.changes[i];
    const ContactSurface& surface = contact.surfaces.surfaces[i];
    if (!change.is_any()) continue;
    table.add(surface.name, change.faces_gained, change.faces_lost, surface.faces.size(), change.lofted_lost,
              surface.lofted_elements.size());
  }
  return table.empty() ? "" : table.format();
}

}  // namespace

std::string format_deaths(const DeathTally& tally, const State& state, DeathLog detail,
                          const ContactModel* contact, const Mesh& mesh) {
  std::string text = fmt::format("Element death at step {}, time {:.6e}: {} died, {} dead", state.step,
                                 state.time, pluralize(tally.n_died, "element"), tally.n_dead);
  if (tally.n_dying > 0) text += fmt::format(", {} dying", tally.n_dying);
  if (contact == nullptr) return text + "\n";
  text += format_counts(tally);
  if (detail != DeathLog::minimal) text += format_changes(tally, *contact);
  if (detail == DeathLog::full) text += format_surface_tables(*contact, summarize(*contact, mesh));
  return text;
}

std::string format_death_total(const DeathTally& tally, std::size_t n_may_die) {
  return fmt::format("\nElement death\n  {} of {} that may die are dead, {} dying\n",
                     pluralize(tally.n_dead, "element"), n_may_die, tally.n_dying);
}

}  // namespace contactsim

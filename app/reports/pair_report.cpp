// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/pair_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "app/reports/interaction_report.hpp"
#include "app/reports/number.hpp"
#include "app/reports/smoothing_report.hpp"
#include "app/reports/text_table.hpp"
#include "core/base/pluralize.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

/// General contact of a thousand blocks makes half a million pairs, which nobody reads.
constexpr std::size_t max_rows = 1000;

std::uint32_t n_faces(const SurfaceSummary& s) {
  return s.owned + s.top + s.bottom + s.side + s.prisms + s.spheres;
}

std::string formulation_of(const SurfacePair& pair) {
  if (pair.formulation == ConstraintFormulation::face_face) return "face_face";
  return pair.is_one_sided ? "node_face one-sided" : "node_face";
}

/// The table with the rows of the pairs that are chosen, up to max_rows; the others are counted.
std::string format_chosen(const ContactModel& model, TextTable table,
                          const std::function<bool(PairIndex)>& is_chosen,
                          const std::function<void(TextTable&, PairIndex)>& add_row) {
  std::size_t n_rows = 0, n_more = 0;
  for (const PairIndex i : indices(model.pairs)) {
    if (!is_chosen(i)) continue;
    if (n_rows < max_rows) {
      add_row(table, i);
      ++n_rows;
    } else {
      ++n_more;
    }
  }
  return (table.empty() ? "" : table.format()) +
         (n_more > 0 ? fmt::format("      and {}\n", pluralize(n_more, "more pair")) : "");
}

TextTable start_table() {
  return pair_table({name_column("interaction", 22),
                     {"line", 6},
                     name_column("law", 16),
                     name_column("formulation", 19),
                     {"first\nfaces", 9},
                     {"second\nfaces", 9},
                     {"first\nnodes", 9},
                     {"second\nnodes", 9},
                     {"smallest gap", 13},
                     {"in reach", 9}});
}

void add_start(const ContactModel& model, const SurfaceSummaries& summaries,
               IndexedSpan<PairIndex, const InitialGap> starts, PairIndex i, TextTable& table) {
  const SurfacePair& pair = model.pairs[i];
  const SurfaceSummary &a = summaries[pair.first], &b = summaries[pair.second];
  table.add(i.value + 1, model.surfaces.surfaces[pair.first].name, model.surfaces.surfaces[pair.second].name,
            pair.interaction, pair.location.line, describe_law(*pair.law), formulation_of(pair), n_faces(a),
            n_faces(b), a.nodes, b.nodes, starts.empty() ? "-" : number(starts[i].smallest_gap),
            starts.empty() ? "-" : fmt::to_string(starts[i].n_in_reach));
}

TextTable history_table() {
  return pair_table({{"contact time", 13},
                     {"peak force", 13},
                     {"deepest", 13},
                     {"of thickness", 13},
                     {"friction work", 13},
                     {"impulse x", 13},
                     {"impulse y", 13},
                     {"impulse z", 13},
                     {"work", 13},
                     {"made", 13}});
}

void add_history(const ContactModel& model, const PairHistory& history, PairIndex i, TextTable& table) {
  const SurfacePair& pair = model.pairs[i];
  table.add(i.value + 1, model.surfaces.surfaces[pair.first].name, model.surfaces.surfaces[pair.second].name,
            number(history.contact_time), number(history.peak_force), number(history.deepest),
            number(history.deepest_share), number(history.friction_work), number(history.impulse.x()),
            number(history.impulse.y()), number(history.impulse.z()), number(history.work + history.impact),
            number(history.made()));
}

}  // namespace

TextTable pair_table(std::vector<TextTable::Column> columns) {
  columns.insert(columns.begin(), {{"no", 4}, name_column("first", 20), name_column("second", 20)});
  return {0, 3, std::move(columns)};
}

std::string format_pairs(const ContactModel& model, const SurfaceSummaries& summaries,
                         IndexedSpan<PairIndex, const InitialGap> starts,
                         IndexedSpan<PairIndex, const AutomaticLengths> lengths) {
  assert(starts.empty() || starts.size() == model.pairs.size());
  if (model.pairs.empty()) return "";
  const auto is_far = [&](PairIndex i) {
    return !starts.empty() && starts[i].n_in_reach == 0 && model.pairs[i].is_from_defaults;
  };
  std::string text = "\nContact pairs\n";
  text += format_chosen(
      model, start_table(), [&](PairIndex i) { return !is_far(i); },
      [&](TextTable& table, PairIndex i) { add_start(model, summaries, starts, i, table); });
  std::size_t n_far = 0;
  for (const PairIndex i : indices(model.pairs)) n_far += is_far(i) ? 1 : 0;
  if (n_far > 0) {
    text +=
        fmt::format("      {} of general or self contact with nothing in reach\n", pluralize(n_far, "pair"));
  }
  return text + format_interactions(model, lengths) + format_smoothings(model);
}

std::string format_pair_histories(const ContactModel& model,
                                  IndexedSpan<PairIndex, const PairHistory> histories) {
  assert(histories.size() == model.pairs.size());
  if (model.pairs.empty()) return "";
  const auto has_touched = [&](PairIndex i) { return histories[i].has_touched(); };
  std::string text;
  if (std::ranges::any_of(indices(model.pairs), has_touched)) {
    text = "\nContact of pairs in the run\n" +
           format_chosen(model, history_table(), has_touched,
                         [&](TextTable& table, PairIndex i) { add_history(model, histories[i], i, table); });
  }
  if (!std::ranges::all_of(indices(model.pairs), has_touched)) {
    text += "\nPairs that never touched\n" +
            format_chosen(model, pair_table({name_column("interaction", 22), {"line", 6}}),
                          std::not_fn(has_touched), [&](TextTable& table, PairIndex i) {
                            const SurfacePair& pair = model.pairs[i];
                            table.add(i.value + 1, model.surfaces.surfaces[pair.first].name,
                                      model.surfaces.surfaces[pair.second].name, pair.interaction,
                                      pair.location.line);
                          });
  }
  return text;
}

}  // namespace contactsim

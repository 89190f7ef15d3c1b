// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/pair_report.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <functional>
#include <optional>
#include <set>

#include "core/base/pluralize.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

/// General contact of a thousand blocks makes half a million pairs, which nobody reads.
constexpr std::size_t max_rows = 1000;

constexpr const char* start_format =
    "{:>4}  {:<28} {:<28} {:<22} {:>6}  {:<16} {:<19} {:>9} {:>9} {:>9} {:>9} {:>13} {:>9}\n";
constexpr const char* settings_format =
    "      {:<22} {:>6}  {:<13} {:<16} {:>11} {:>11} {:>11} {:>11} {:>11} {:>9} {:>11} {:>9}\n";
constexpr const char* history_format =
    "{:>4}  {:<28} {:<28} {:>13} {:>13} {:>13} {:>13} {:>13} {:>13} {:>13} {:>13} {:>13} {:>13}\n";

std::string number(double value) { return std::isnan(value) ? "-" : fmt::format("{:.6g}", value); }

std::string number_or(const std::optional<double>& value, const char* otherwise) {
  return value ? number(*value) : otherwise;
}

std::uint32_t n_faces(const SurfaceSummary& s) {
  return s.owned + s.top + s.bottom + s.side + s.prisms + s.spheres;
}

std::string formulation_of(const SurfacePair& pair) {
  if (pair.formulation == ConstraintFormulation::face_face) return "face_face";
  return pair.is_one_sided ? "node_face one-sided" : "node_face";
}

/// Writes the rows of the pairs that are chosen, up to max_rows; the others are counted.
std::string format_chosen(const ContactModel& model, const std::function<bool(PairIndex)>& is_chosen,
                          const std::function<std::string(PairIndex)>& format_row) {
  std::string text;
  std::size_t n_rows = 0, n_more = 0;
  for (const PairIndex i : indices(model.pairs)) {
    if (!is_chosen(i)) continue;
    if (n_rows < max_rows) {
      text += format_row(i);
      ++n_rows;
    } else {
      ++n_more;
    }
  }
  if (n_more > 0) text += fmt::format("      and {}\n", pluralize(n_more, "more pair"));
  return text;
}

std::string format_start(const ContactModel& model, std::span<const SurfaceSummary> summaries,
                         IndexedSpan<PairIndex, const InitialGap> starts, PairIndex i) {
  const SurfacePair& pair = model.pairs[i];
  const SurfaceSummary &a = summaries[pair.first], &b = summaries[pair.second];
  return fmt::format(start_format, i.value + 1, model.surfaces.surfaces[pair.first].name,
                     model.surfaces.surfaces[pair.second].name, pair.interaction, pair.location.line,
                     describe_law(*pair.law), formulation_of(pair), n_faces(a), n_faces(b), a.nodes, b.nodes,
                     starts.empty() ? "-" : number(starts[i].smallest_gap),
                     starts.empty() ? "-" : fmt::to_string(starts[i].n_in_reach));
}

/// Calls write(pair) for the first pair of every interaction, in order.
template <class Write>
void for_each_interaction(const ContactModel& model, const Write& write) {
  std::set<std::pair<std::string, std::string>> reported;
  for (const SurfacePair& pair : model.pairs) {
    if (reported.insert({pair.interaction, to_string(pair.location)}).second) write(pair);
  }
}

/// Every interaction that has a pair, once, in the order of its first pair.
std::string format_settings(const ContactModel& model) {
  std::string text = fmt::format(settings_format, "", "", "", "", "normal", "tangential", "overlap",
                                 "overlap", "capture", "penalty", "penalty", "damping");
  text += fmt::format(settings_format, "interaction", "line", "behavior", "enforcement", "tolerance",
                      "tolerance", "normal", "tangential", "tolerance", "scale", "stiffness", "fraction");
  for_each_interaction(model, [&](const SurfacePair& pair) {
    const bool is_fixed = pair.behavior == InteractionBehavior::infinitesimal_sliding;
    text += fmt::format(
        settings_format, pair.interaction, pair.location.line, is_fixed ? "infinitesimal" : "sliding",
        pair.enforcement == Enforcement::penalty ? "penalty" : "momentum_balance",
        number_or(pair.normal_tolerance, "auto"), number_or(pair.tangential_tolerance, "auto"),
        number_or(pair.overlap_normal_tolerance, "auto"),
        number_or(pair.overlap_tangential_tolerance, "auto"), number_or(pair.capture_tolerance, "0"),
        number(pair.penalty_scale), number_or(pair.penalty_stiffness, "auto"), number(pair.damping_fraction));
  });
  return text + "      tolerances and overlaps are lengths, auto: from the size of each face\n";
}

/// What the gaps of the start count as.
std::string describe_start(const GapSettings& gap) {
  if (gap.initial_clearance) return "as " + number(*gap.initial_clearance);
  if (gap.overlap_ramp_time) return fmt::format("overlaps come in within {}", number(*gap.overlap_ramp_time));
  return gap.ignore_initial_overlap.value_or(false) ? "overlaps as just touching" : "as meshed";
}

/// Every interaction whose gaps are not those of the mesh, once.
std::string format_gaps(const ContactModel& model) {
  constexpr const char* gaps_format = "      {:<22} {:>6}  {:>11}  {}\n";
  std::string text;
  for_each_interaction(model, [&](const SurfacePair& pair) {
    if (pair.gap == GapSettings{}) return;
    text += fmt::format(gaps_format, pair.interaction, pair.location.line,
                        number(pair.gap.contact_offset.value_or(0.0)), describe_start(pair.gap));
  });
  if (text.empty()) return "";
  return "\nGaps of interactions\n" +
         fmt::format(gaps_format, "interaction", "line", "offset", "at the start") + text;
}

std::string format_history(const ContactModel& model, const PairHistory& history, PairIndex i) {
  const SurfacePair& pair = model.pairs[i];
  return fmt::format(history_format, i.value + 1, model.surfaces.surfaces[pair.first].name,
                     model.surfaces.surfaces[pair.second].name, number(history.contact_time),
                     number(history.peak_force), number(history.impulse.x()), number(history.impulse.y()),
                     number(history.impulse.z()), number(history.work + history.impact),
                     number(history.friction_work), number(history.made()), number(history.deepest),
                     number(history.deepest_share));
}

}  // namespace

std::string format_pairs(const ContactModel& model, std::span<const SurfaceSummary> summaries,
                         IndexedSpan<PairIndex, const InitialGap> starts) {
  assert(starts.empty() || starts.size() == model.pairs.size());
  if (model.pairs.empty()) return "";
  const auto is_far = [&](PairIndex i) {
    return !starts.empty() && starts[i].n_in_reach == 0 && model.pairs[i].is_from_defaults;
  };
  std::string text = "\nContact pairs\n" + fmt::format(start_format, "no", "first", "second", "interaction",
                                                       "line", "law", "formulation", "faces", "faces",
                                                       "nodes", "nodes", "smallest gap", "in reach");
  text += format_chosen(
      model, [&](PairIndex i) { return !is_far(i); },
      [&](PairIndex i) { return format_start(model, summaries, starts, i); });
  std::size_t n_far = 0;
  for (const PairIndex i : indices(model.pairs)) n_far += is_far(i) ? 1 : 0;
  if (n_far > 0) {
    text +=
        fmt::format("      {} of general or self contact with nothing in reach\n", pluralize(n_far, "pair"));
  }
  return text + "\nSettings of interactions\n" + format_settings(model) + format_gaps(model);
}

std::string format_pair_histories(const ContactModel& model,
                                  IndexedSpan<PairIndex, const PairHistory> histories) {
  assert(histories.size() == model.pairs.size());
  if (model.pairs.empty()) return "";
  const std::string rows = format_chosen(
      model, [&](PairIndex i) { return histories[i].has_touched(); },
      [&](PairIndex i) { return format_history(model, histories[i], i); });
  const std::string idle = format_chosen(
      model, [&](PairIndex i) { return !histories[i].has_touched(); },
      [&](PairIndex i) {
        const SurfacePair& pair = model.pairs[i];
        return fmt::format("{:>4}  {:<28} {:<28} {:<22} {:>6}\n", i.value + 1,
                           model.surfaces.surfaces[pair.first].name,
                           model.surfaces.surfaces[pair.second].name, pair.interaction, pair.location.line);
      });
  std::string text;
  if (!rows.empty()) {
    text = "\nContact of pairs in the run\n" +
           fmt::format(history_format, "no", "first", "second", "contact time", "peak force", "impulse x",
                       "impulse y", "impulse z", "work", "friction work", "made", "deepest", "of thickness") +
           rows;
  }
  if (!idle.empty()) text += "\nPairs that never touched\n" + idle;
  return text;
}

}  // namespace contactsim

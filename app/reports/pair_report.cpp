// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/pair_report.hpp"

#include <fmt/format.h>

#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "app/reports/number.hpp"
#include "app/reports/smoothing_report.hpp"
#include "core/base/pluralize.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

/// General contact of a thousand blocks makes half a million pairs, which nobody reads.
constexpr std::size_t max_rows = 1000;

constexpr const char* start_format =
    "{:>4}  {:<28} {:<28} {:<22} {:>6}  {:<16} {:<19} {:>9} {:>9} {:>9} {:>9} {:>13} {:>9}\n";
constexpr const char* settings_format =
    "      {:<22} {:>6}  {:<13} {:<16} {:>20} {:>20} {:>20} {:>11} {:>20} {:>9} {:>11} {:>9}\n";
constexpr const char* history_format =
    "{:>4}  {:<28} {:<28} {:>13} {:>13} {:>13} {:>13} {:>13} {:>13} {:>13} {:>13} {:>13} {:>13}\n";

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

std::string format_start(const ContactModel& model, const SurfaceSummaries& summaries,
                         IndexedSpan<PairIndex, const InitialGap> starts, PairIndex i) {
  const SurfacePair& pair = model.pairs[i];
  const SurfaceSummary &a = summaries[pair.first], &b = summaries[pair.second];
  return fmt::format(start_format, i.value + 1, model.surfaces.surfaces[pair.first].name,
                     model.surfaces.surfaces[pair.second].name, pair.interaction, pair.location.line,
                     describe_law(*pair.law), formulation_of(pair), n_faces(a), n_faces(b), a.nodes, b.nodes,
                     starts.empty() ? "-" : number(starts[i].smallest_gap),
                     starts.empty() ? "-" : fmt::to_string(starts[i].n_in_reach));
}

/// An interaction, by its first pair.
struct InteractionRow {
  const SurfacePair* pair;
  AutomaticLengths lengths;  ///< of all of its pairs
  bool holds = false;        ///< the law of some of them goes by a capture tolerance
};

/// Every interaction that has a pair, once, in the order of its first pair.
std::vector<InteractionRow> list_interactions(const ContactModel& model,
                                              IndexedSpan<PairIndex, const AutomaticLengths> lengths) {
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  std::vector<InteractionRow> rows;
  for (const PairIndex i : indices(model.pairs)) {
    const SurfacePair& pair = model.pairs[i];
    const auto [found, is_new] = known.try_emplace({pair.interaction, to_string(pair.location)}, rows.size());
    if (is_new) rows.push_back({&pair, {}});
    InteractionRow& listed = rows[found->second];
    if (!lengths.empty()) listed.lengths.add(lengths[i]);
    const InterfaceLawRow& law = row_of(*pair.law);
    listed.holds = listed.holds || law.holds_at_start || law.select != nullptr;
  }
  return rows;
}

/// A length that is given, or "auto" and what it comes to.
///   factor  on the range [1]
std::string length_or_auto(const std::optional<double>& given, const LengthRange& range,
                           double factor = 1.0) {
  if (given) return number(*given);
  if (!range.exists()) return "auto";
  const std::string least = fmt::format("{:.3g}", factor * range.least),
                    most = fmt::format("{:.3g}", factor * range.most);
  return least == most ? "auto " + least : fmt::format("auto {}..{}", least, most);
}

std::string format_settings(const std::vector<InteractionRow>& rows) {
  std::string text = fmt::format(settings_format, "", "", "", "", "normal", "tangential", "overlap",
                                 "overlap", "capture", "penalty", "penalty", "damping");
  text += fmt::format(settings_format, "interaction", "line", "behavior", "enforcement", "tolerance",
                      "tolerance", "normal", "tangential", "tolerance", "scale", "stiffness", "fraction");
  for (const InteractionRow& listed : rows) {
    const SurfacePair& pair = *listed.pair;
    const bool is_fixed = pair.behavior == InteractionBehavior::infinitesimal_sliding;
    // Faces on faces reach beyond no edge.
    const LengthRange beyond =
        pair.formulation == ConstraintFormulation::node_face ? listed.lengths.tangential : LengthRange{};
    const auto capture = pair.capture_tolerance ? pair.capture_tolerance : pair.normal_tolerance;
    text += fmt::format(
        settings_format, pair.interaction, pair.location.line, is_fixed ? "infinitesimal" : "sliding",
        pair.enforcement == Enforcement::penalty ? "penalty" : "momentum_balance",
        length_or_auto(pair.normal_tolerance, listed.lengths.normal),
        length_or_auto(pair.tangential_tolerance, beyond),
        length_or_auto(pair.overlap_normal_tolerance, listed.lengths.overlap_normal),
        number_or(pair.overlap_tangential_tolerance, "auto"),
        listed.holds ? length_or_auto(capture, listed.lengths.capture) : "-", number(pair.penalty_scale),
        number_or(pair.penalty_stiffness, "auto"), number(pair.damping_fraction));
  }
  return text +
         "      tolerances and overlaps are lengths, auto: from the size of each face, the smallest and the "
         "largest\n";
}

/// Every interaction with a line that says how far its sides reach, once.
std::string format_reach(const std::vector<InteractionRow>& rows) {
  constexpr const char* reach_format = "      {:<22} {:>6}  {:>15} {:>17} {:>15}  {}\n";
  constexpr double search_edges = 2.0, closure_edges = 0.05;
  std::string text;
  for (const InteractionRow& listed : rows) {
    const SurfacePair& pair = *listed.pair;
    if (!pair.search_distance && !pair.tracking_distance && !pair.closes_gaps()) continue;
    text += fmt::format(
        reach_format, pair.interaction, pair.location.line,
        pair.search_distance ? length_or_auto(pair.search_distance->given, listed.lengths.edge, search_edges)
                             : "all",
        length_or_auto(pair.tracking_distance, listed.lengths.normal),
        pair.gap_closure ? length_or_auto(pair.gap_closure->given, listed.lengths.edge, closure_edges) : "-",
        pair.adjusted_nodes ? pair.adjusted_nodes->text : "-");
  }
  if (text.empty()) return "";
  return "\nReach of interactions\n" +
         fmt::format(reach_format, "interaction", "line", "search distance", "tracking distance",
                     "gap closure", "adjusted nodes") +
         text;
}

/// What the gaps of the start count as.
std::string describe_start(const GapSettings& gap) {
  if (gap.initial_clearance) return "as " + number(*gap.initial_clearance);
  if (gap.overlap_ramp_time) return fmt::format("overlaps come in within {}", number(*gap.overlap_ramp_time));
  return gap.ignore_initial_overlap.value_or(false) ? "overlaps as just touching" : "as meshed";
}

/// Every interaction whose gaps are not those of the mesh, once.
std::string format_gaps(const std::vector<InteractionRow>& rows) {
  constexpr const char* gaps_format = "      {:<22} {:>6}  {:>11}  {}\n";
  std::string text;
  for (const InteractionRow& listed : rows) {
    const SurfacePair& pair = *listed.pair;
    if (pair.gap == GapSettings{}) continue;
    text += fmt::format(gaps_format, pair.interaction, pair.location.line,
                        number(pair.gap.contact_offset.value_or(0.0)), describe_start(pair.gap));
  }
  if (text.empty()) return "";
  return "\nGaps of interactions\n" +
         fmt::format(gaps_format, "interaction", "line", "offset", "at the start") + text;
}

/// Every interaction whose sides may not part, or of whose shells one side takes part alone, once.
std::string format_sides(const std::vector<InteractionRow>& rows) {
  constexpr const char* sides_format = "      {:<22} {:>6}  {:>10}  {:<7} {:<7}\n";
  std::string text;
  for (const InteractionRow& listed : rows) {
    const SurfacePair& pair = *listed.pair;
    if (pair.separates && !pair.is_polar()) continue;
    text += fmt::format(sides_format, pair.interaction, pair.location.line, pair.separates ? "on" : "off",
                        name_of(pair.sides[0]), name_of(pair.sides[1]));
  }
  if (text.empty()) return "";
  return "\nSides of interactions\n" +
         fmt::format(sides_format, "interaction", "line", "separation", "first", "second") + text;
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

std::string_view name_of(ShellSides sides) {
  constexpr std::array<std::string_view, 3> names{"both", "top", "bottom"};
  return names[static_cast<std::size_t>(sides)];
}

std::string format_pairs(const ContactModel& model, const SurfaceSummaries& summaries,
                         IndexedSpan<PairIndex, const InitialGap> starts,
                         IndexedSpan<PairIndex, const AutomaticLengths> lengths) {
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
  const auto rows = list_interactions(model, lengths);
  return text + "\nSettings of interactions\n" + format_settings(rows) + format_reach(rows) +
         format_gaps(rows) + format_sides(rows) + format_smoothings(model);
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

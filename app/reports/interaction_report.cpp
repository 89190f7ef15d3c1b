// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/interaction_report.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "app/reports/number.hpp"
#include "app/reports/text_table.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

/// Name and line of an interaction, then the columns of a table.
TextTable interaction_table(std::vector<TextTable::Column> columns) {
  columns.insert(columns.begin(), {name_column("interaction", 20), {"line", 6}});
  return {6, 2, std::move(columns)};
}

std::string number_or(const std::optional<double>& value, const char* otherwise) {
  return value ? number(*value) : otherwise;
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

TextTable settings_table() {
  return interaction_table({name_column("behavior", 13),
                            name_column("enforcement", 16),
                            {"normal\ntolerance", 20},
                            {"tangential\ntolerance", 20},
                            {"overlap\nnormal", 20},
                            {"overlap\ntangential", 11},
                            {"capture\ntolerance", 20},
                            {"penalty\nscale", 9},
                            {"penalty\nstiffness", 11},
                            {"damping\nfraction", 9}});
}

std::string_view name_of(Enforcement enforcement) {
  switch (enforcement) {
    case Enforcement::momentum_balance:
      return "momentum_balance";
    case Enforcement::penalty:
      return "penalty";
    case Enforcement::augmented_lagrange:
      break;
  }
  return "augmented_lagrange";
}

std::string format_settings(const std::vector<InteractionRow>& rows) {
  TextTable table = settings_table();
  for (const InteractionRow& listed : rows) {
    const SurfacePair& pair = *listed.pair;
    const bool is_fixed = pair.behavior == InteractionBehavior::infinitesimal_sliding;
    // Faces on faces reach beyond no edge.
    const LengthRange beyond =
        pair.formulation == ConstraintFormulation::node_face ? listed.lengths.tangential : LengthRange{};
    const auto capture = pair.capture_tolerance ? pair.capture_tolerance : pair.normal_tolerance;
    table.add(pair.interaction, pair.location.line, is_fixed ? "infinitesimal" : "sliding",
              name_of(pair.enforcement), length_or_auto(pair.normal_tolerance, listed.lengths.normal),
              length_or_auto(pair.tangential_tolerance, beyond),
              length_or_auto(pair.overlap_normal_tolerance, listed.lengths.overlap_normal),
              number_or(pair.overlap_tangential_tolerance, "auto"),
              listed.holds ? length_or_auto(capture, listed.lengths.capture) : "-",
              number(pair.penalty_scale), number_or(pair.penalty_stiffness, "auto"),
              number(pair.damping_fraction));
  }
  return table.format() +
         "      tolerances and overlaps are lengths, auto: from the size of each face, the smallest and the "
         "largest\n";
}

/// A table under its title; "" of one without rows.
std::string format_titled(const char* title, const TextTable& table) {
  return table.empty() ? "" : fmt::format("\n{}\n{}", title, table.format());
}

/// Every interaction with a line that says how far its sides reach, once.
std::string format_reach(const std::vector<InteractionRow>& rows) {
  constexpr double search_edges = 2.0, closure_edges = 0.05;
  TextTable table = interaction_table({{"search distance", 15},
                                       {"tracking distance", 17},
                                       {"gap closure", 15},
                                       name_column("adjusted nodes", 14)});
  for (const InteractionRow& listed : rows) {
    const SurfacePair& pair = *listed.pair;
    if (!pair.search_distance && !pair.tracking_distance && !pair.closes_gaps()) continue;
    table.add(
        pair.interaction, pair.location.line,
        pair.search_distance ? length_or_auto(pair.search_distance->given, listed.lengths.edge, search_edges)
                             : "all",
        length_or_auto(pair.tracking_distance, listed.lengths.normal),
        pair.gap_closure ? length_or_auto(pair.gap_closure->given, listed.lengths.edge, closure_edges) : "-",
        pair.adjusted_nodes ? pair.adjusted_nodes->text : "-");
  }
  return format_titled("Reach of interactions", table);
}

/// What the gaps of the start count as.
std::string describe_start(const GapSettings& gap) {
  if (gap.initial_clearance) return "as " + number(*gap.initial_clearance);
  if (gap.overlap_ramp_time) return fmt::format("overlaps come in within {}", number(*gap.overlap_ramp_time));
  return gap.ignore_initial_overlap.value_or(false) ? "overlaps as just touching" : "as meshed";
}

/// Every interaction whose gaps are not those of the mesh, once.
std::string format_gaps(const std::vector<InteractionRow>& rows) {
  TextTable table = interaction_table({{"offset", 11}, text_column("at the start")});
  for (const InteractionRow& listed : rows) {
    const SurfacePair& pair = *listed.pair;
    if (pair.gap == GapSettings{}) continue;
    table.add(pair.interaction, pair.location.line, number(pair.gap.contact_offset.value_or(0.0)),
              describe_start(pair.gap));
  }
  return format_titled("Gaps of interactions", table);
}

/// Every interaction whose sides may not part, or of whose shells one side takes part alone, once.
std::string format_sides(const std::vector<InteractionRow>& rows) {
  TextTable table =
      interaction_table({{"separation", 10}, name_column("first", 7), name_column("second", 7)});
  for (const InteractionRow& listed : rows) {
    const SurfacePair& pair = *listed.pair;
    if (pair.separates && !pair.is_polar()) continue;
    table.add(pair.interaction, pair.location.line, pair.separates ? "on" : "off", name_of(pair.sides[0]),
              name_of(pair.sides[1]));
  }
  return format_titled("Sides of interactions", table);
}

}  // namespace

std::string_view name_of(ShellSides sides) {
  constexpr std::array<std::string_view, 3> names{"both", "top", "bottom"};
  return names[static_cast<std::size_t>(sides)];
}

std::string format_interactions(const ContactModel& model,
                                IndexedSpan<PairIndex, const AutomaticLengths> lengths) {
  const auto rows = list_interactions(model, lengths);
  return "\nSettings of interactions\n" + format_settings(rows) + format_reach(rows) + format_gaps(rows) +
         format_sides(rows);
}

}  // namespace contactsim

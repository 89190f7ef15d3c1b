// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/overlap_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/reports/number.hpp"
#include "app/reports/pair_report.hpp"
#include "app/reports/text_table.hpp"
#include "core/base/pluralize.hpp"

namespace contactsim {

std::string format_start_overlaps(std::span<const StartOverlap> overlaps, const ContactModel& model,
                                  const Mesh& mesh) {
  if (overlaps.empty()) return "";
  TextTable table =
      pair_table({{"nodes", 9}, {"faces", 9}, {"deep", 9}, {"deepest overlap", 15}, {"at node", 10}});
  for (const StartOverlap& overlap : overlaps) {
    const SurfacePair& pair = model.pairs[overlap.pair];
    table.add(overlap.pair.value + 1, model.surfaces.surfaces[pair.first].name,
              model.surfaces.surfaces[pair.second].name, overlap.n_nodes, overlap.n_faces, overlap.n_deep,
              number(overlap.deepest), mesh.node_id(overlap.node));
  }
  return "\nOverlap at the start\n" + table.format() +
         "      deep: nodes more than half an element, or half a shell's thickness, behind the surface\n";
}

namespace {

/// The node that moved most, by its id.
std::string name_largest(const OverlapMoves& moves, const Mesh& mesh) {
  return moves.n_nodes > 0 ? fmt::to_string(mesh.node_id(moves.largest_node)) : "-";
}

/// The gaps that were closed, of the pairs that close any; "" of none.
std::string format_closures(const OverlapRemoved& removed, const ContactModel& model, const Mesh& mesh) {
  TextTable table = pair_table({{"nodes moved", 11},
                                {"widest gap", 11},
                                {"largest move", 12},
                                {"rms move", 11},
                                {"of node", 8},
                                {"left", 11}});
  for (const OverlapMoves& moves : removed.moves) {
    const SurfacePair& pair = model.pairs[moves.pair];
    if (!pair.closes_gaps()) continue;
    table.add(moves.pair.value + 1, model.surfaces.surfaces[pair.first].name,
              model.surfaces.surfaces[pair.second].name, moves.n_nodes, number(moves.widest),
              number(moves.largest), number(moves.mean_square), name_largest(moves, mesh),
              number(moves.left_open));
  }
  if (table.empty()) return "";
  std::string text = "\nGaps closed at the start\n" + table.format();
  if (removed.squeezed)
    text += fmt::format("      smallest volume of a moved element over that before: {:.4g}, element {}\n",
                        removed.volume_share, mesh.element_id(*removed.squeezed));
  return text;
}

}  // namespace

std::string format_overlap(const OverlapRemoved& removed, const ContactModel& model, const Mesh& mesh) {
  const auto overlaps = [](const OverlapMoves& moves) { return moves.deepest > 0.0; };
  if (std::ranges::none_of(removed.moves, overlaps))
    return "\nOverlap removal: no surfaces overlap\n" + format_closures(removed, model, mesh);
  const auto passes = [](std::int64_t n) { return pluralize(static_cast<std::size_t>(n), "pass", "passes"); };
  std::string text = fmt::format("\nOverlap removal in {}\n", passes(removed.n_passes));
  if (removed.n_body_passes > 0)
    text += fmt::format("  before, in {}, bodies that lay deep in others went apart as wholes\n",
                        passes(removed.n_body_passes));
  TextTable table = pair_table(
      {{"nodes moved", 11}, {"deepest overlap", 15}, {"largest move", 13}, {"of node", 10}, {"left", 13}});
  for (const OverlapMoves& moves : removed.moves) {
    if (!overlaps(moves)) continue;
    const SurfacePair& pair = model.pairs[moves.pair];
    table.add(moves.pair.value + 1, model.surfaces.surfaces[pair.first].name,
              model.surfaces.surfaces[pair.second].name, moves.n_nodes, number(moves.deepest),
              number(moves.largest), name_largest(moves, mesh), number(moves.left));
  }
  return text + table.format() + format_closures(removed, model, mesh);
}

}  // namespace contactsim

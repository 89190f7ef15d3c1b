// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/overlap_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/pluralize.hpp"

namespace contactsim {

std::string format_start_overlaps(std::span<const StartOverlap> overlaps, const ContactModel& model,
                                  const Mesh& mesh) {
  if (overlaps.empty()) return "";
  constexpr const char* row = "{:>4}  {:<28} {:<28} {:>9} {:>9} {:>9} {:>15} {:>10}\n";
  std::string text = "\nOverlap at the start\n" + fmt::format(row, "no", "first", "second", "nodes", "faces",
                                                              "deep", "deepest overlap", "at node");
  for (const StartOverlap& overlap : overlaps) {
    const SurfacePair& pair = model.pairs[overlap.pair];
    text += fmt::format(row, overlap.pair.value + 1, model.surfaces.surfaces[pair.first].name,
                        model.surfaces.surfaces[pair.second].name, overlap.n_nodes, overlap.n_faces,
                        overlap.n_deep, fmt::format("{:.6g}", overlap.deepest), mesh.node_id(overlap.node));
  }
  return text +
         "      deep: nodes more than half an element, or half a shell's thickness, behind the surface\n";
}

namespace {

/// The gaps that were closed, of the pairs that close any; "" of none.
std::string format_closures(const OverlapRemoved& removed, const ContactModel& model, const Mesh& mesh) {
  constexpr const char* closure_format = "{:>4}  {:<28} {:<28} {:>11} {:>13} {:>13} {:>13} {:>10} {:>13}\n";
  std::string text;
  for (const OverlapMoves& moves : removed.moves) {
    const SurfacePair& pair = model.pairs[moves.pair];
    if (!pair.closes_gaps()) continue;
    const std::string node = moves.n_nodes > 0 ? fmt::to_string(mesh.node_id(moves.largest_node)) : "-";
    text +=
        fmt::format(closure_format, moves.pair.value + 1, model.surfaces.surfaces[pair.first].name,
                    model.surfaces.surfaces[pair.second].name, moves.n_nodes,
                    fmt::format("{:.6g}", moves.widest), fmt::format("{:.6g}", moves.largest),
                    fmt::format("{:.6g}", moves.mean_square), node, fmt::format("{:.6g}", moves.left_open));
  }
  if (text.empty()) return "";
  text = "\nGaps closed at the start\n" +
         fmt::format(closure_format, "no", "first", "second", "nodes moved", "widest gap", "largest move",
                     "rms move", "of node", "left") +
         text;
  if (removed.squeezed)
    text += fmt::format("      smallest volume of a moved element over that before: {:.4g}, element {}\n",
                        removed.volume_share, mesh.element_id(*removed.squeezed));
  return text;
}

}  // namespace

std::string format_overlap(const OverlapRemoved& removed, const ContactModel& model, const Mesh& mesh) {
  constexpr const char* row = "{:>4}  {:<28} {:<28} {:>11} {:>15} {:>13} {:>10} {:>13}\n";
  const auto overlaps = [](const OverlapMoves& moves) { return moves.deepest > 0.0; };
  if (std::ranges::none_of(removed.moves, overlaps))
    return "\nOverlap removal: no surfaces overlap\n" + format_closures(removed, model, mesh);
  const auto passes = [](std::int64_t n) { return pluralize(static_cast<std::size_t>(n), "pass", "passes"); };
  std::string text = fmt::format("\nOverlap removal in {}\n", passes(removed.n_passes));
  if (removed.n_body_passes > 0)
    text += fmt::format("  before, in {}, bodies that lay deep in others went apart as wholes\n",
                        passes(removed.n_body_passes));
  text += fmt::format(row, "no", "first", "second", "nodes moved", "deepest overlap", "largest move",
                      "of node", "left");
  for (const OverlapMoves& moves : removed.moves) {
    if (!overlaps(moves)) continue;
    const SurfacePair& pair = model.pairs[moves.pair];
    const std::string node = moves.n_nodes > 0 ? fmt::to_string(mesh.node_id(moves.largest_node)) : "-";
    text += fmt::format(row, moves.pair.value + 1, model.surfaces.surfaces[pair.first].name,
                        model.surfaces.surfaces[pair.second].name, moves.n_nodes,
                        fmt::format("{:.6g}", moves.deepest), fmt::format("{:.6g}", moves.largest), node,
                        fmt::format("{:.6g}", moves.left));
  }
  return text + format_closures(removed, model, mesh);
}

}  // namespace contactsim

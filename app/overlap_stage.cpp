// SPDX-License-Identifier: BSD-3-Clause
#include "app/overlap_stage.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/counted.hpp"
#include "core/conditions/kinematics.hpp"
#include "core/errors.hpp"

namespace contactsim {

namespace {

/// Overlap that is left is worth a warning when it is this share of what there was.
constexpr double worrying_share = 1e-3;

/// [n_nodes] 1 for the nodes that conditions hold or drive in all directions at the start; empty when there
/// are none, or when the conditions are wrong, which the run tells.
std::vector<std::uint8_t> find_held_nodes(const RunInput& input) {
  if (!input.procedure.time_control) return {};
  Diagnostics unheard;
  const ConditionScope scope{input.definition, input.region, input.procedure.time_control->blocks, input.mesh,
                             unheard};
  const Kinematics kinematics = make_kinematics(scope);
  if (unheard.has_errors() || kinematics.nodes().empty()) return {};
  const Eigen::Index n = input.mesh.coordinates().cols();
  const Eigen::Matrix3Xd rest = Eigen::Matrix3Xd::Zero(3, n);
  const BetweenSteps start{scope.start_time(), 0.0, 1.0, input.mesh.coordinates(), rest};
  // Two accelerations that differ in a direction that no deck has come out equal where nothing is free.
  Eigen::Matrix3Xd one = rest, other = rest.colwise() + Eigen::Vector3d(1.0, std::sqrt(2.0), std::exp(1.0));
  try {
    kinematics.constrain(start, one);
    kinematics.constrain(start, other);
  } catch (const SolveError&) {
    return {};
  }
  std::vector<std::uint8_t> is_held(static_cast<std::size_t>(n), 0);
  for (const NodeIndex node : kinematics.nodes()) {
    const double difference = (one.col(node.value) - other.col(node.value)).norm();
    is_held[node.value] = difference < 1e-12 ? 1 : 0;
  }
  return is_held;
}

void warn_of_rest(const OverlapRemoved& removed, const ContactModel& model, Diagnostics& warnings) {
  for (const OverlapMoves& moves : removed.moves) {
    if (moves.left <= worrying_share * moves.deepest) continue;
    const SurfacePair& pair = model.pairs[moves.pair];
    warnings.add_warning(
        "overlap-left", pair.location,
        fmt::format("'{}' and '{}' still overlap by {:.4g} after overlap removal",
                    model.surfaces.surfaces[pair.first].name, model.surfaces.surfaces[pair.second].name,
                    moves.left),
        "held nodes stay where they are; more OVERLAP ITERATIONS, or SHELL OVERLAP ITERATIONS for "
        "shells, beams and particles, may help");
  }
}

}  // namespace

std::string format_overlap(const OverlapRemoved& removed, const ContactModel& model, const Mesh& mesh) {
  constexpr const char* row = "{:>4}  {:<28} {:<28} {:>11} {:>15} {:>13} {:>10} {:>13}\n";
  if (removed.moves.empty()) return "\nOverlap removal: no surfaces overlap\n";
  std::string text = fmt::format("\nOverlap removal in {}\n",
                                 counted(static_cast<std::size_t>(removed.n_passes), "pass", "passes"));
  text += fmt::format(row, "no", "first", "second", "nodes moved", "deepest overlap", "largest move",
                      "of node", "left");
  for (const OverlapMoves& moves : removed.moves) {
    const SurfacePair& pair = model.pairs[moves.pair];
    const std::string node = moves.n_nodes > 0 ? fmt::to_string(mesh.node_id(moves.largest_node)) : "-";
    text += fmt::format(row, moves.pair + 1, model.surfaces.surfaces[pair.first].name,
                        model.surfaces.surfaces[pair.second].name, moves.n_nodes,
                        fmt::format("{:.6g}", moves.deepest), fmt::format("{:.6g}", moves.largest), node,
                        fmt::format("{:.6g}", moves.left));
  }
  return text;
}

std::optional<Mesh> remove_initial_overlap(const RunInput& input, Log& log, Diagnostics& warnings) {
  if (input.contact == nullptr) return std::nullopt;
  const OverlapRemoval& settings = input.region.contact->overlap_removal;
  if (!settings.is_on() && !settings.is_all_there_is) return std::nullopt;
  OverlapRemoved removed =
      remove_overlap(*input.contact, input.mesh, *input.region.contact, find_held_nodes(input));
  log.write(format_overlap(removed, *input.contact, input.mesh));
  warn_of_rest(removed, *input.contact, warnings);
  if (removed.n_passes == 0) return std::nullopt;
  return input.mesh.with_coordinates(std::move(removed.coordinates));
}

}  // namespace contactsim

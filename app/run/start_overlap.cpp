// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/start_overlap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/overlap/body_parting.hpp"
#include "contact/overlap/initial_gaps.hpp"
#include "core/base/errors.hpp"
#include "core/base/pluralize.hpp"
#include "core/conditions/kinematic_constraints.hpp"
#include "core/definition/procedure.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

/// Overlap that is left is worth a warning when it is this share of what there was.
constexpr double worrying_remainder = 1e-3;

/// Overlap above this share of the size of the face is worth a warning: less is round-off of the mesh's
/// maker.
constexpr double worrying_depth = 1e-4;

/// [n_nodes] held_fully for the nodes that conditions hold or drive in all directions at the start,
/// held_in_part for those that they do in some; empty when there are none, or when the conditions are wrong,
/// which the run reports.
std::vector<std::uint8_t> find_held_nodes(const RunInput& input) {
  if (!input.procedure.time_control) return {};
  Diagnostics discarded;
  const ConditionScope scope{input.definition, input.region,
                             input.procedure.time_control->time_stepping_blocks, input.mesh, discarded};
  const KinematicConstraints kinematic_constraints = make_kinematic_constraints(scope);
  if (discarded.has_errors() || kinematic_constraints.nodes().empty()) return {};
  const Eigen::Index n = input.mesh.coordinates().cols();
  const Eigen::Matrix3Xd rest = Eigen::Matrix3Xd::Zero(3, n);
  const BetweenSteps start{scope.start_time(), 0.0, 1.0, input.mesh.coordinates(), rest};
  // Two accelerations that differ in a direction that no deck has come out equal where nothing is free.
  Eigen::Matrix3Xd one = rest, other = rest.colwise() + Eigen::Vector3d(1.0, std::sqrt(2.0), std::exp(1.0));
  try {
    kinematic_constraints.constrain(start, one);
    kinematic_constraints.constrain(start, other);
  } catch (const SolveError&) {
    return {};
  }
  std::vector<std::uint8_t> is_held(static_cast<std::size_t>(n), 0);
  for (const NodeIndex node : kinematic_constraints.nodes()) {
    const double difference = (one.col(node.value) - other.col(node.value)).norm();
    is_held[node.value] = difference < 1e-12 ? held_fully : held_in_part;
  }
  return is_held;
}

void warn_of_rest(const OverlapRemoved& removed, const ContactModel& model, Diagnostics& warnings) {
  for (const OverlapMoves& moves : removed.moves) {
    if (moves.left <= worrying_remainder * moves.deepest) continue;
    const SurfacePair& pair = model.pairs[moves.pair];
    warnings.add_warning(
        "overlap-left", pair.location,
        fmt::format("{} still overlap by {:.4g} after overlap removal", names_of(model, moves.pair),
                    moves.left),
        "held nodes stay where they are; more OVERLAP ITERATIONS, or SHELL OVERLAP ITERATIONS for "
        "shells, beams and particles, may help");
  }
}

/// Gaps that stay open as nodes are held, and nodes that were moved for two pairs.
void warn_of_closures(const OverlapRemoved& removed, const ContactModel& model, Diagnostics& warnings) {
  for (const OverlapMoves& moves : removed.moves) {
    const SurfacePair& pair = model.pairs[moves.pair];
    const std::string names = names_of(model, moves.pair);
    if (moves.left_open > worrying_remainder * moves.widest)
      warnings.add_warning(
          "gap-left", pair.location,
          fmt::format("a gap of {:.4g} between {} stays open, of {:.4g} that was to be closed",
                      moves.left_open, names, moves.widest),
          "held nodes stay where they are; more OVERLAP ITERATIONS may help");
    if (pair.closes_gaps() && moves.n_again > 0)
      warnings.add_warning("gap-closed-twice", pair.location,
                           fmt::format("{} moved for {} had been moved for an earlier pair already",
                                       pluralize(moves.n_again, "node"), names),
                           "the last move counts: gaps of the earlier pair may be open again");
  }
}

/// Stops when elements would be turned inside out: the run could not begin with them.
void stop_at_turned(const OverlapRemoved& removed, const RunInput& input) {
  if (removed.turned.empty()) return;
  const TurnedElement& first = removed.turned.front();
  const Mesh& mesh = input.mesh;
  const auto& control = input.procedure.time_control;
  const double time = control && !control->time_stepping_blocks.empty()
                          ? control->time_stepping_blocks.front().start_time
                          : 0.0;
  throw SolveError(
      time,
      fmt::format("overlap removal between {} would turn {} inside out, the first of them element {} of "
                  "{}; no node has been moved. Move the bodies apart in the mesh, refine it less there, "
                  "or set a smaller OVERLAP NORMAL TOLERANCE",
                  names_of(*input.contact, first.pair), pluralize(removed.turned.size(), "element"),
                  mesh.element_id(first.element),
                  mesh.name({EntityKind::block, mesh.block_of(first.element)})));
}

std::string describe(const StartOverlap& overlap, const ContactModel& model, const Mesh& mesh) {
  std::string text = fmt::format(
      "{} overlap at the start: {} behind {}, deepest by {:.4g} at node {}", names_of(model, overlap.pair),
      pluralize(overlap.n_nodes, "node"),
      overlap.n_faces > 0 ? pluralize(overlap.n_faces, "face or edge", "faces and edges") : "a plane",
      overlap.deepest, mesh.node_id(overlap.node));
  if (overlap.other) text += fmt::format(", beside node {} of the other side", mesh.node_id(*overlap.other));
  if (overlap.n_deep > 0)
    text += fmt::format("; {} deeper than half an element or sheet, where contact takes no notice",
                        pluralize(overlap.n_deep, "node lies", "nodes lie"));
  return text;
}

}  // namespace

std::string names_of(const ContactModel& model, PairIndex pair) {
  const auto& surfaces = model.surfaces.surfaces;
  return fmt::format("'{}' and '{}'", surfaces[model.pairs[pair].first].name,
                     surfaces[model.pairs[pair].second].name);
}

void warn_of_overlaps(const RunInput& input, std::span<const StartOverlap> overlaps,
                      IndexedSpan<PairIndex, const double> stored, Diagnostics& warnings) {
  if (input.contact == nullptr || input.region.contact->overlap_removal.is_on()) return;
  const bool takes_over = input.earlier != nullptr && !input.procedure.transfers.empty();
  const char* hint = takes_over ? "the state that is taken over has them there"
                                : "INITIAL OVERLAP REMOVAL = ON in the contact definition moves them apart "
                                  "before the first step";
  for (const StartOverlap& overlap : overlaps) {
    const SurfacePair& pair = input.contact->pairs[overlap.pair];
    const bool is_tied = row_of(*pair.law).holding == ContactLaw::tied;
    if (pair.closes_gaps()) continue;
    if (is_tied || (pair.gap.needs_start() && overlap.n_deep == 0) ||
        !(overlap.deepest > worrying_depth * overlap.size))
      continue;
    std::string text = describe(overlap, *input.contact, input.mesh);
    if (!stored.empty() && stored[overlap.pair] > 0.0)
      text += fmt::format("; contact stores {:.4g} of energy in it, which the bodies will get",
                          stored[overlap.pair]);
    warnings.add_warning("overlap-at-start", pair.location, text, hint);
  }
}

IndexedVector<PairIndex, double> find_offset_overlaps(const RunInput& input) {
  const ContactModel& model = *input.contact;
  IndexedVector<PairIndex, double> depths(model.pairs.size(), 0.0);
  const auto may_overlap = [](const SurfacePair& pair) {
    return pair.gap.initial_clearance.value_or(0.0) < 0.0 ||
           (pair.gap.contact_offset.value_or(0.0) > 0.0 && !pair.gap.needs_start());
  };
  if (std::ranges::none_of(model.pairs, may_overlap)) return depths;
  const InitialGaps starts = find_initial_gaps(model, input.mesh, input.region.contact->dash);
  for (const PairIndex i : indices(model.pairs)) {
    if (!may_overlap(model.pairs[i]) || std::isnan(starts[i].smallest_gap)) continue;
    const GapSettings& gap = model.pairs[i].gap;
    const double counts =
        gap.initial_clearance.value_or(starts[i].smallest_gap - gap.contact_offset.value_or(0.0));
    depths[i] = std::max(0.0, -counts);
  }
  return depths;
}

void warn_of_offsets(const ContactModel& model, IndexedSpan<PairIndex, const double> depths,
                     IndexedSpan<PairIndex, const double> stored, Diagnostics& warnings) {
  for (const PairIndex i : indices(model.pairs)) {
    const SurfacePair& pair = model.pairs[i];
    if (!(depths[i] > 0.0) || !pair.gap.contact_offset) continue;
    std::string text = fmt::format("{} overlap by {:.4g} at the start, by their CONTACT OFFSET of {:.4g}",
                                   names_of(model, i), depths[i], *pair.gap.contact_offset);
    if (stored[i] > 0.0)
      text += fmt::format("; contact stores {:.4g} of energy in it, which the bodies will get", stored[i]);
    warnings.add_warning(
        "offset-overlap", pair.location, text,
        "IGNORE INITIAL OVERLAP = ON has them just touch, OVERLAP RAMP TIME brings it in slowly");
  }
}

std::optional<OverlapRemoved> remove_initial_overlap(const RunInput& input) {
  if (input.contact == nullptr) return std::nullopt;
  const OverlapRemoval& settings = input.region.contact->overlap_removal;
  const bool closes_gaps = std::ranges::any_of(input.contact->pairs, &SurfacePair::closes_gaps);
  if (!settings.is_on() && !settings.is_all_there_is && !closes_gaps) return std::nullopt;
  return remove_overlap(*input.contact, input.mesh, *input.region.contact, find_held_nodes(input));
}

std::optional<Mesh> move_nodes(const RunInput& input, OverlapRemoved removed, Diagnostics& warnings) {
  stop_at_turned(removed, input);
  warn_of_rest(removed, *input.contact, warnings);
  warn_of_closures(removed, *input.contact, warnings);
  const auto moves_nodes = [](const OverlapMoves& moves) { return moves.n_nodes > 0; };
  if (std::ranges::none_of(removed.moves, moves_nodes)) return std::nullopt;
  return input.mesh.with_coordinates(std::move(removed.coordinates));
}

}  // namespace contactsim

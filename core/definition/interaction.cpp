// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/interaction.hpp"

namespace contactsim {

namespace {

template <class V>
void fill(std::optional<V>& own, const std::optional<V>& fallback) {
  if (!own) own = fallback;
}

/// A pair that says itself what its start counts as does not take another way from its defaults.
GapSettings with_defaults(GapSettings own, const GapSettings& defaults) {
  const bool has_start =
      own.initial_clearance || own.ignore_initial_overlap.has_value() || own.overlap_ramp_time;
  if (!own.initial_clearance) fill(own.contact_offset, defaults.contact_offset);
  if (has_start) return own;
  if (!own.contact_offset) fill(own.initial_clearance, defaults.initial_clearance);
  fill(own.ignore_initial_overlap, defaults.ignore_initial_overlap);
  fill(own.overlap_ramp_time, defaults.overlap_ramp_time);
  return own;
}

}  // namespace

PairSettings with_defaults(PairSettings own, const PairSettings& defaults) {
  fill(own.friction_model, defaults.friction_model);
  fill(own.formulation, defaults.formulation);
  fill(own.behavior, defaults.behavior);
  fill(own.normal_tolerance, defaults.normal_tolerance);
  fill(own.tangential_tolerance, defaults.tangential_tolerance);
  fill(own.overlap_normal_tolerance, defaults.overlap_normal_tolerance);
  fill(own.overlap_tangential_tolerance, defaults.overlap_tangential_tolerance);
  fill(own.capture_tolerance, defaults.capture_tolerance);
  fill(own.separation, defaults.separation);
  fill(own.sides, defaults.sides);
  fill(own.tracking_distance, defaults.tracking_distance);
  fill(own.search_distance, defaults.search_distance);
  own.gap = with_defaults(own.gap, defaults.gap);
  fill(own.gap_closure, defaults.gap_closure);
  fill(own.adjusted_nodes, defaults.adjusted_nodes);
  fill(own.smoothing, defaults.smoothing);
  fill(own.enforcement, defaults.enforcement);
  fill(own.penalty_scale, defaults.penalty_scale);
  fill(own.penalty_stiffness, defaults.penalty_stiffness);
  fill(own.damping_fraction, defaults.damping_fraction);
  fill(own.stabilization.scale, defaults.stabilization.scale);
  fill(own.stabilization.tangential_fraction, defaults.stabilization.tangential_fraction);
  fill(own.stabilization.remaining_fraction, defaults.stabilization.remaining_fraction);
  fill(own.stabilization.range, defaults.stabilization.range);
  return own;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/interaction.hpp"

namespace contactsim {

namespace {

template <class V>
void fill(std::optional<V>& own, const std::optional<V>& fallback) {
  if (!own) own = fallback;
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
  fill(own.enforcement, defaults.enforcement);
  fill(own.penalty_scale, defaults.penalty_scale);
  fill(own.penalty_stiffness, defaults.penalty_stiffness);
  fill(own.damping_fraction, defaults.damping_fraction);
  return own;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/hardening.hpp"

namespace contactsim {

FlowStress PowerHardening::at(const Lanes& eqps, const Lanes& increment, double /*dt*/) const {
  const Lanes strain = (eqps + increment - luders_strain).max(0.0);
  const Lanes hardened = constant * strain.pow(exponent);
  const Lanes slope = (strain > 0.0).select(exponent * hardened / strain, 0.0);
  return {yield_stress + hardened, slope};
}

FlowStress VoceHardening::at(const Lanes& eqps, const Lanes& increment, double /*dt*/) const {
  const Lanes missing = growth * (-coefficient * (eqps + increment)).exp();
  return {yield_stress + growth - missing, coefficient * missing};
}

FlowStress JohnsonCookHardening::at(const Lanes& eqps, const Lanes& increment, double dt) const {
  const FlowStress slow = power.at(eqps, increment, dt);
  const Lanes rate = increment / (dt * reference_rate);
  const LaneMask is_fast = rate > 1.0;
  const Lanes factor = 1.0 + rate_constant * rate.max(1.0).log();
  const Lanes factor_slope = is_fast.select(rate_constant / increment, 0.0);
  return {slow.value * factor, slow.slope * factor + slow.value * factor_slope};
}

}  // namespace contactsim

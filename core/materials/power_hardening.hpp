// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/materials/hardening_row.hpp"
#include "core/materials/plastic_law.hpp"

namespace contactsim {

/// Flow stress that grows with a power of the plastic strain beyond the Lueders strain.
/// Source: Sierra/SM, EP_POWER_HARD.
struct PowerHardening {
  double yield_stress = 0.0;   ///< > 0 [force/length^2]
  double constant = 0.0;       ///< >= 0 [force/length^2]
  double exponent = 1.0;       ///< > 0 [1]
  double luders_strain = 0.0;  ///< >= 0 [1]
  static constexpr bool has_back_stress = false;
  static constexpr std::array variables = plastic_strain_only;
  static constexpr double kinematic_modulus = 0.0;

  FlowStress at(const Lanes& eqps, const Lanes& increment, double /*dt*/) const {
    const Lanes strain = (eqps + increment - luders_strain).max(0.0);
    const Lanes hardened = constant * strain.pow(exponent);
    const Lanes slope = (strain > 0.0).select(exponent * hardened / strain, 0.0);
    return {yield_stress + hardened, slope};
  }
  double min_slope() const { return 0.0; }
};

extern template struct PlasticLaw<PowerHardening>;

/// The lines of the power law.
inline std::vector<Parameter> power_parameters() {
  return {
      parameter::non_negative("hardening constant", "Factor of the power law [force/length^2]").required(),
      parameter::positive("hardening exponent", "Exponent of the power law [1]").required(),
  };
}

inline HardeningRow power_hardening() {
  return {"power_law",
          {"ep_power_hard", "power_law_hardening"},
          "Plasticity with power-law hardening",
          joined({power_parameters(),
                  {parameter::non_negative("luders strain", "Plastic strain before hardening begins [1]")
                       .otherwise(0.0)}}),
          &law_kind<PlasticLaw<PowerHardening>>,
          [](const MaterialInput& input) -> std::optional<MaterialLaw> {
            const ParameterValues& values = input.values;
            return PlasticLaw<PowerHardening>{
                input.moduli(),
                {values.real("yield stress"), values.real("hardening constant"),
                 values.real("hardening exponent"), values.real("luders strain")}};
          }};
}

}  // namespace contactsim

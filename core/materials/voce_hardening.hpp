// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

#include <fmt/format.h>

#include "core/materials/hardening_row.hpp"
#include "core/materials/plastic_law.hpp"

namespace contactsim {

/// Flow stress that grows towards an end. Source: Voce, J. Inst. Metals 74 (1948) 537-562; Sierra/SM,
/// J2_PLASTICITY.
struct VoceHardening {
  double yield_stress = 0.0;  ///< > 0 [force/length^2]
  double growth = 0.0;        ///< from the first to the last flow stress, >= 0 [force/length^2]
  double coefficient = 1.0;   ///< > 0 [1]
  static constexpr bool has_back_stress = false;
  static constexpr std::array variables = plastic_strain_only;
  static constexpr double kinematic_modulus = 0.0;

  FlowStress at(const Lanes& eqps, const Lanes& increment, double /*dt*/) const {
    const Lanes missing = growth * (-coefficient * (eqps + increment)).exp();
    return {yield_stress + growth - missing, coefficient * missing};
  }
  double min_slope() const { return 0.0; }
};

extern template struct PlasticLaw<VoceHardening>;

inline HardeningRow voce_hardening() {
  return {"voce",
          {},
          "Plasticity with hardening towards an end",
          {parameter::real("hardening modulus", "What is added in the end [force/length^2]").required(),
           parameter::positive("exponential coefficient",
                               "One over the plastic strain in which most of it is added [1]")
               .required()},
          &law_kind<PlasticLaw<VoceHardening>>,
          [](const MaterialInput& input) -> std::optional<MaterialLaw> {
            const double growth = input.values.real("hardening modulus");
            if (growth < 0.0)
              throw std::invalid_argument(
                  fmt::format("the hardening modulus of voce must not be negative, found {}", growth));
            return PlasticLaw<VoceHardening>{
                input.moduli(),
                {input.values.real("yield stress"), growth, input.values.real("exponential coefficient")}};
          }};
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

#include "core/materials/hardening_row.hpp"
#include "core/materials/plastic_law.hpp"

namespace contactsim {

/// Flow stress that grows in proportion to the plastic strain, or a part of it, with a back stress that takes
/// the rest. Source: Sierra/SM, ELASTIC_PLASTIC; Simo and Hughes, Computational Inelasticity (1998), box 3.1.
struct LinearHardening {
  double yield_stress = 0.0;       ///< > 0 [force/length^2]
  double isotropic_modulus = 0.0;  ///< beta times the hardening modulus [force/length^2]
  double kinematic_modulus = 0.0;  ///< the rest of it [force/length^2]
  static constexpr bool has_back_stress = true;
  static constexpr std::array variables = plastic_strain_and_back_stress;

  FlowStress at(const Lanes& eqps, const Lanes& increment, double /*dt*/) const {
    const Lanes value = yield_stress + isotropic_modulus * (eqps + increment);
    return {value.max(0.0), (value > 0.0).select(Lanes::Constant(isotropic_modulus), 0.0)};
  }
  double min_slope() const { return isotropic_modulus; }
};

extern template struct PlasticLaw<LinearHardening>;

inline HardeningRow linear_hardening() {
  return {"linear",
          {"elastic_plastic"},
          "Plasticity with linear hardening",
          {parameter::real("hardening modulus", "Slope of stress over plastic strain [force/length^2]")
               .required(),
           isotropic_share()},
          &law_kind<PlasticLaw<LinearHardening>>,
          [](const MaterialInput& input) -> std::optional<MaterialLaw> {
            const double modulus = input.values.real("hardening modulus"), beta = input.values.real("beta");
            const ElasticModuli moduli = input.moduli();
            if (!(3.0 * moduli.shear + modulus > 0.0)) {
              throw std::invalid_argument(
                  "the hardening modulus falls faster than three times the shear modulus");
            }
            return PlasticLaw<LinearHardening>{
                moduli, {input.values.real("yield stress"), beta * modulus, (1.0 - beta) * modulus}};
          }};
}

}  // namespace contactsim

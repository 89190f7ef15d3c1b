// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

#include "core/materials/linear_hardening.hpp"
#include "core/materials/multilinear_hardening.hpp"
#include "core/materials/power_hardening.hpp"
#include "core/materials/voce_hardening.hpp"

namespace contactsim {

/// A factor of the flow stress by the rate of the plastic strain, 1 at rest:
///   johnson_cook          1 + constant ln(rate / reference rate), rates below the reference counting as it
///   power_law_breakdown   1 + asinh((rate / coefficient)^(1 / exponent))
/// Source: Johnson and Cook, 7th Int. Symp. on Ballistics (1983) 541-547; Frost and Ashby,
/// Deformation-Mechanism Maps (1982), 2.2; Sierra/SM, J2_PLASTICITY.
struct RateFactor {
  enum class Kind { rate_independent, johnson_cook, power_law_breakdown };
  Kind kind = Kind::rate_independent;
  double constant = 0.0;        ///< >= 0 [1]
  double reference_rate = 1.0;  ///< > 0 [1/time]
  double coefficient = 1.0;     ///< > 0 [1/time]
  double exponent = 1.0;        ///< > 0 [1]

  struct Value {
    Lanes factor;  ///< [1]
    Lanes slope;   ///< over the rate [time]
  };
  Value at(const Lanes& rate) const;
};

/// A flow stress whose first value and whose growth depend on the rate each by a factor of its own,
///   yield stress x yield factor + (flow stress at rest - yield stress) x growth factor.
/// Source: Sierra/SM, J2_PLASTICITY, HARDENING MODEL = DECOUPLED_FLOW_STRESS, without temperature.
struct RateHardening {
  using AtRest = std::variant<LinearHardening, PowerHardening, VoceHardening, MultilinearHardening>;
  AtRest at_rest;             ///< of isotropic growth that does not fall
  double yield_stress = 0.0;  ///< > 0 [force/length^2]
  RateFactor of_yield, of_growth;
  static constexpr bool has_back_stress = false;
  static constexpr std::array variables = plastic_strain_only;
  static constexpr double kinematic_modulus = 0.0;

  FlowStress at(const Lanes& eqps, const Lanes& increment, double dt) const;
  double min_slope() const { return 0.0; }
};

extern template struct PlasticLaw<RateHardening>;

/// The lines of J2_PLASTICITY that say how the flow stress depends on rate and temperature.
std::vector<Parameter> rate_parameters();

/// Whether some factor depends on the rate.
bool has_rate_factor(const ParameterValues& values);

/// Lines of the chosen factors that are missing, by their phrases.
std::vector<std::string> missing_rate_parameters(const ParameterValues& values);

/// Warns of constants of a factor that is not chosen ("rate-without-multiplier").
void warn_of_idle_rates(const MaterialInput& input);

/// The law of a hardening at rest with the factors of the deck. Throws std::invalid_argument for growth that
/// is not isotropic, or that falls.
std::optional<MaterialLaw> make_rate_law(const MaterialInput& input, const MaterialLaw& at_rest);

}  // namespace contactsim

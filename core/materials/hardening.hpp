// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/base/lanes.hpp"
#include "core/materials/hardening_curve.hpp"
#include "core/materials/state_variable.hpp"

/// Flow stresses of the plastic laws: how large the equivalent stress may be.
namespace contactsim {

/// A flow stress and its slope over the plastic increment.
struct FlowStress {
  Lanes value;  ///< >= 0 [force/length^2]
  Lanes slope;  ///< [force/length^2]
};

/// The equivalent plastic strain of laws without a back stress.
inline constexpr std::array plastic_strain_only{StateVariable{"eqps", 0, 1, "equivalent plastic strain [1]"}};

/// Flow stress that grows in proportion to the plastic strain, or a part of it, with a back stress that takes
/// the rest. Source: Sierra/SM, ELASTIC_PLASTIC; Simo and Hughes, Computational Inelasticity (1998), box 3.1.
struct LinearHardening {
  double yield_stress = 0.0;       ///< > 0 [force/length^2]
  double isotropic_modulus = 0.0;  ///< beta times the hardening modulus [force/length^2]
  double kinematic_modulus = 0.0;  ///< the rest of it [force/length^2]
  static constexpr bool has_back_stress = true;
  static constexpr std::array variables{
      StateVariable{"eqps", 6, 1, "equivalent plastic strain [1]"},
      StateVariable{"back_stress", 0, 6, "centre of the yield surface [force/length^2]"}};

  FlowStress at(const Lanes& eqps, const Lanes& increment, double /*dt*/) const {
    const Lanes value = yield_stress + isotropic_modulus * (eqps + increment);
    return {value.max(0.0), (value > 0.0).select(Lanes::Constant(isotropic_modulus), 0.0)};
  }
  double min_slope() const { return isotropic_modulus; }
};

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

  FlowStress at(const Lanes& eqps, const Lanes& increment, double dt) const;
  double min_slope() const { return 0.0; }
};

/// Flow stress that grows towards an end. Source: Voce, J. Inst. Metals 74 (1948) 537-562; Sierra/SM,
/// J2_PLASTICITY.
struct VoceHardening {
  double yield_stress = 0.0;  ///< > 0 [force/length^2]
  double growth = 0.0;        ///< from the first to the last flow stress, >= 0 [force/length^2]
  double coefficient = 1.0;   ///< > 0 [1]
  static constexpr bool has_back_stress = false;
  static constexpr std::array variables = plastic_strain_only;
  static constexpr double kinematic_modulus = 0.0;

  FlowStress at(const Lanes& eqps, const Lanes& increment, double dt) const;
  double min_slope() const { return 0.0; }
};

/// Flow stress that grows with a power of the plastic strain and the logarithm of its rate; rates below the
/// reference count as the reference. Source: Johnson and Cook, 7th Int. Symp. on Ballistics (1983) 541-547,
/// without temperature.
struct JohnsonCookHardening {
  PowerHardening power;         ///< with no Lueders strain
  double rate_constant = 0.0;   ///< >= 0 [1]
  double reference_rate = 1.0;  ///< > 0 [1/time]
  static constexpr bool has_back_stress = false;
  static constexpr std::array variables = plastic_strain_only;
  static constexpr double kinematic_modulus = 0.0;

  FlowStress at(const Lanes& eqps, const Lanes& increment, double dt) const;
  double min_slope() const { return 0.0; }
};

/// Flow stress along a curve, of whose growth a back stress takes a part.
/// Source: Sierra/SM, MULTILINEAR_EP; Simo and Hughes, Computational Inelasticity (1998), box 3.1.
struct MultilinearHardening {
  HardeningCurve curve;  ///< of the flow stress under growing load
  double beta = 1.0;     ///< share of isotropic hardening, 0 to 1 [1]
  static constexpr bool has_back_stress = true;
  static constexpr std::array variables = LinearHardening::variables;

  /// Radius of the yield surface where the curve has come to a stress [force/length^2].
  Lanes radius(const Lanes& stress) const { return (1.0 - beta) * curve.first_stress() + beta * stress; }
  FlowStress at(const Lanes& eqps, const Lanes& increment, double /*dt*/) const {
    const HardeningCurve::Place place = curve.at(eqps + increment);
    return {radius(place.stress), beta * place.slope};
  }
};

}  // namespace contactsim

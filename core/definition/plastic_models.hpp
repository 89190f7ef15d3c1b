// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "core/base/names.hpp"
#include "core/definition/elastic_constants.hpp"

/// PARAMETERS FOR MODEL of the models that flow.
namespace contactsim {

/// PARAMETERS FOR MODEL ELASTIC_PLASTIC: linear hardening.
struct ElasticPlasticModel {
  ElasticConstants elastic;
  double yield_stress = std::numeric_limits<double>::quiet_NaN();       ///< > 0 [force/length^2]
  double hardening_modulus = std::numeric_limits<double>::quiet_NaN();  ///< [force/length^2]
  double beta = 1.0;  ///< 1 isotropic, 0 kinematic hardening [1]
};

/// PARAMETERS FOR MODEL EP_POWER_HARD, also POWER_LAW_HARDENING:
/// flow stress = yield_stress + hardening_constant * (eqps - luders_strain)^hardening_exponent.
struct PowerHardeningModel {
  ElasticConstants elastic;
  double yield_stress = std::numeric_limits<double>::quiet_NaN();        ///< > 0 [force/length^2]
  double hardening_constant = std::numeric_limits<double>::quiet_NaN();  ///< >= 0 [force/length^2]
  double hardening_exponent = std::numeric_limits<double>::quiet_NaN();  ///< > 0 [1]
  double luders_strain = 0.0;                                            ///< >= 0 [1]
};

/// PARAMETERS FOR MODEL JOHNSON_COOK, without temperature:
/// flow stress = (yield_stress + hardening_constant * eqps^hardening_exponent) * (1 + rate_constant * ln(rate
/// / reference_rate)). Source: Johnson and Cook, 7th Int. Symp. on Ballistics (1983) 541-547.
struct JohnsonCookModel {
  ElasticConstants elastic;
  double yield_stress = std::numeric_limits<double>::quiet_NaN();        ///< > 0 [force/length^2]
  double hardening_constant = std::numeric_limits<double>::quiet_NaN();  ///< >= 0 [force/length^2]
  double hardening_exponent = std::numeric_limits<double>::quiet_NaN();  ///< > 0 [1]
  double rate_constant = 0.0;                                            ///< >= 0 [1]
  double reference_rate = 1.0;                                           ///< > 0 [1/time]
  std::optional<double> d1, d2, d3, d4, d5;  ///< of the failure strain; absent: no failure [1]
};

/// PARAMETERS FOR MODEL MULTILINEAR_EP: hardening along a curve.
struct MultilinearModel {
  ElasticConstants elastic;
  double yield_stress = std::numeric_limits<double>::quiet_NaN();  ///< > 0 [force/length^2]
  double beta = 1.0;                                               ///< 1 isotropic, 0 kinematic hardening [1]
  std::optional<DeckName> hardening_function;  ///< [force/length^2] over the plastic strain
};

/// PARAMETERS FOR MODEL ML_EP_FAIL: the same with failure.
struct TearingModel {
  MultilinearModel plastic;
  double critical_tearing = std::numeric_limits<double>::quiet_NaN();  ///< > 0 [1]
  double critical_opening = std::numeric_limits<double>::quiet_NaN();  ///< strain of a crack, > 0 [1]
};

enum class HardeningModel : std::uint8_t { linear, power_law, voce, user_defined, decoupled_flow_stress };

/// PARAMETERS FOR MODEL J2_PLASTICITY, without rates and temperature: the hardening is chosen by name. Voce's
/// flow stress is yield_stress + hardening_modulus * (1 - exp(-exponential_coefficient * eqps)); the others
/// are those of the models above.
struct J2Model {
  ElasticConstants elastic;
  std::optional<HardeningModel> hardening;                         ///< HARDENING MODEL
  std::optional<HardeningModel> isotropic_hardening;               ///< of DECOUPLED_FLOW_STRESS
  double yield_stress = std::numeric_limits<double>::quiet_NaN();  ///< > 0 [force/length^2]
  double beta = 1.0;                                               ///< 1 isotropic, 0 kinematic hardening [1]
  double hardening_modulus = std::numeric_limits<double>::quiet_NaN();        ///< [force/length^2]
  double exponential_coefficient = std::numeric_limits<double>::quiet_NaN();  ///< > 0 [1]
  double hardening_constant = std::numeric_limits<double>::quiet_NaN();       ///< >= 0 [force/length^2]
  double hardening_exponent = std::numeric_limits<double>::quiet_NaN();       ///< > 0 [1]
  double luders_strain = 0.0;                                                 ///< >= 0 [1]
  std::optional<DeckName> hardening_function;  ///< [force/length^2] over the plastic strain

  /// How the yield surface grows; nothing when the deck does not say so.
  std::optional<HardeningModel> flow_stress() const {
    return hardening == HardeningModel::decoupled_flow_stress ? isotropic_hardening : hardening;
  }
};

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/names.hpp"

namespace contactsim {

/// The constants of isotropic elasticity; a model that is used has exactly two of them.
struct ElasticConstants {
  std::optional<double> youngs_modulus;  ///< > 0 [force/length^2]
  std::optional<double> poissons_ratio;  ///< > -1, < 0.5 [1]
  std::optional<double> shear_modulus;   ///< > 0 [force/length^2]
  std::optional<double> bulk_modulus;    ///< > 0 [force/length^2]
  std::optional<double> lambda;          ///< Lame's first constant [force/length^2]
};

/// PARAMETERS FOR MODEL ELASTIC: hypoelastic, finite strain.
struct ElasticModel {
  ElasticConstants elastic;
};

/// PARAMETERS FOR MODEL LINEAR_ELASTIC: small strain.
struct LinearElasticModel {
  ElasticConstants elastic;
};

/// PARAMETERS FOR MODEL NEO_HOOKEAN: hyperelastic.
struct NeoHookeanModel {
  ElasticConstants elastic;
};

/// PARAMETERS FOR MODEL MOONEY_RIVLIN: hyperelastic. C10 and C01 give the shear modulus, an elastic constant
/// the bulk modulus; a second one is compared.
struct MooneyRivlinModel {
  ElasticConstants elastic;
  double c10 = std::numeric_limits<double>::quiet_NaN();  ///< [force/length^2]
  double c01 = std::numeric_limits<double>::quiet_NaN();  ///< [force/length^2]
};

/// A turn of a coordinate system about one of its axes.
struct AxisRotation {
  std::int64_t axis = 1;  ///< 1, 2 or 3
  double angle = 0.0;     ///< [degrees]
};

/// PARAMETERS FOR MODEL ELASTIC_ORTHOTROPIC: hypoelastic. Poisson's ratio nu_ab is the contraction along b
/// under a stress along a.
struct OrthotropicModel {
  ElasticConstants elastic;  ///< of an isotropic material that is alike; none or two
  double e11 = std::numeric_limits<double>::quiet_NaN();   ///< > 0 [force/length^2]
  double e22 = std::numeric_limits<double>::quiet_NaN();   ///< > 0 [force/length^2]
  double e33 = std::numeric_limits<double>::quiet_NaN();   ///< > 0 [force/length^2]
  double nu12 = std::numeric_limits<double>::quiet_NaN();  ///< [1]
  double nu13 = std::numeric_limits<double>::quiet_NaN();  ///< [1]
  double nu23 = std::numeric_limits<double>::quiet_NaN();  ///< [1]
  double g12 = std::numeric_limits<double>::quiet_NaN();   ///< > 0 [force/length^2]
  double g13 = std::numeric_limits<double>::quiet_NaN();   ///< > 0 [force/length^2]
  double g23 = std::numeric_limits<double>::quiet_NaN();   ///< > 0 [force/length^2]
  std::optional<DeckName> coordinate_system;               ///< of the directions 1, 2, 3; absent: global
  AxisRotation first_rotation, second_rotation;            ///< of them, the second about turned axes
};

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

/// One line of a model that contactsim does not know.
struct ModelParameter {
  DeckName key;  ///< words joined by blanks
  std::vector<DeckName> values;
};

/// A model that contactsim does not know: kept as it stands, wrong only when a block uses it.
struct OpaqueModel {
  std::vector<ModelParameter> parameters;
};

/// BEGIN PARAMETERS FOR MODEL <name> inside a material.
struct MaterialModel {
  DeckName name;
  std::variant<OpaqueModel, ElasticModel, LinearElasticModel, NeoHookeanModel, MooneyRivlinModel,
               OrthotropicModel, ElasticPlasticModel, PowerHardeningModel, JohnsonCookModel, MultilinearModel,
               TearingModel, J2Model>
      parameters;
};

/// The elastic constants of a model, null for an opaque one. `model` must outlive the pointer.
const ElasticConstants* find_elastic_constants(const MaterialModel& model);

/// HARDENING FUNCTION of a model, nothing when it has none.
std::optional<DeckName> hardening_function_of(const MaterialModel& model);

}  // namespace contactsim

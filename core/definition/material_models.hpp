// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/names.hpp"
#include "core/definition/elastic_constants.hpp"
#include "core/definition/plastic_models.hpp"

namespace contactsim {

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

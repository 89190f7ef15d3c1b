// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/materials/elastic_constants.hpp"

namespace contactsim {

/// The two moduli in which the laws of isotropic materials are written.
struct ElasticModuli {
  double bulk = 0.0;   ///< > 0 [force/length^2]
  double shear = 0.0;  ///< > 0 [force/length^2]

  double lambda() const { return bulk - 2.0 / 3.0 * shear; }
  double youngs() const { return 9.0 * bulk * shear / (3.0 * bulk + shear); }
  /// Modulus of the pressure wave, bulk + 4/3 shear [force/length^2].
  double p_wave() const { return bulk + 4.0 / 3.0 * shear; }
};

/// The moduli that two elastic constants stand for. Precondition: exactly two are given.
/// Throws std::invalid_argument, with a text for the user, when the two give a modulus that is not positive
/// and finite: such a material has no stable rest. Source: the conversions of isotropic linear elasticity.
ElasticModuli make_elastic_moduli(const ElasticConstants& constants);

}  // namespace contactsim

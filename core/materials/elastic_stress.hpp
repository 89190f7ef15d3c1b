// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "core/materials/elastic_moduli.hpp"
#include "core/materials/strain_step.hpp"

namespace contactsim {

/// The stress at the end of a step that is elastic [force/length^2].
inline SymmetricLanes elastic_stress(const ElasticModuli& moduli, const SymmetricLanes& strain,
                                     const SymmetricLanes& stress) {
  const Lanes volumetric = moduli.lambda() * trace(strain);
  SymmetricLanes trial;
  for (std::size_t i = 0; i < 6; ++i) trial[i] = stress[i] + 2.0 * moduli.shear * strain[i];
  for (std::size_t i = 0; i < 3; ++i) trial[i] += volumetric;
  return trial;
}

/// Bounds of the stiffness of isotropic elasticity.
inline LaneModuli bounds_of(const ElasticModuli& moduli) {
  return {Lanes::Constant(std::max(moduli.bulk, 2.0 / 3.0 * moduli.shear)), Lanes::Constant(moduli.shear)};
}

}  // namespace contactsim

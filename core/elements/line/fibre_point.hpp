// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/materials/material_law.hpp"

/// The stress of a fibre of beams and trusses, as its law updates it.
namespace contactsim {

/// The stress that a fibre keeps, by its area at rest.
///   point  [6 + n_state]
inline FibreLanes fibre_stress(const MaterialLaw& law, std::span<const Lanes> point) {
  FibreLanes stress{point[fibre_places[0]], point[fibre_places[1]], point[fibre_places[2]]};
  if (law.kind().fibre_thinning != nullptr) {
    const Lanes thinning = law.fibre_thinning(point.subspan(6));
    for (Lanes& component : stress) component *= thinning;
  }
  return stress;
}

/// Brings a fibre to the end of a step; returns its stress there, by its area at rest. Precondition: the law
/// has update_fibre.
///   point       [6 + n_state]
///   stiffening  raised to how many times the stiffness of its moduli the fibre may have, see
///   material_law.hpp
inline FibreLanes update_fibre(const MaterialLaw& law, const FibreStep& step, std::span<Lanes> point,
                               Lanes& stiffening) {
  FibreLanes stress{point[fibre_places[0]], point[fibre_places[1]], point[fibre_places[2]]};
  const std::span<Lanes> material = point.subspan(6);
  law.update_fibre(step, stress, material);
  for (std::size_t i = 0; i < 3; ++i) point[fibre_places[i]] = stress[i];
  if (law.kind().fibre_stiffening != nullptr) stiffening = stiffening.max(law.fibre_stiffening(material));
  return fibre_stress(law, point);
}

}  // namespace contactsim

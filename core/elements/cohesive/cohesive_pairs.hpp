// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/base/lanes.hpp"
#include "core/materials/traction_law.hpp"

/// Pairs of opposite nodes of cohesive elements, eight elements at a time; see TractionLaw.
namespace contactsim::cohesive {

/// What a pair remembers: the largest lambda so far [1], opening and sliding [length] now and by how much
/// they have changed in the last step, tractions against them [force/length^2].
enum Number : std::size_t { largest, opening, sliding, open_step, slide_step, normal, tangential, n_numbers };

/// Brings opening and sliding to the end of a step; the largest lambda follows.
///   pair  [n_numbers], here and below
void stretch(const TractionLaw& law, const Lanes& open, const Lanes& slide, std::span<Lanes> pair);

/// Brings the tractions after them; returns their work per area, that of the mean of both ends of the step
/// [energy/length^2]. In compression the interface has its undamaged stiffness times the penetration factor.
///   is_gone  of elements that have failed everywhere, which do not even resist compression
Lanes pull(const TractionLaw& law, const LaneMask& is_gone, std::span<Lanes> pair);

/// Share of the stiffness that is lost: 1 less the traction over lambda by that at first, 0 to 1 [1].
Lanes damage(const TractionLaw& law, std::span<const Lanes> pair);

/// Tangential traction over sliding [force/length^3].
inline Lanes tangential_slope(const TractionLaw& law, std::span<const Lanes> pair) {
  return (1.0 - damage(law, pair)) * law.tangential_stiffness();
}

}  // namespace contactsim::cohesive

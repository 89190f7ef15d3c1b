// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/materials/mooney_rivlin.hpp"
#include "core/materials/neo_hookean.hpp"

/// Hyperelastic laws in shells, beams and trusses: the stretch across, along which there is no stress, is
/// solved for to round-off. Shells and fibres stay along their axes, so that the component of the left
/// Cauchy-Green tensor across them is the squared stretch.
namespace contactsim::hyperelastic {

/// As MooneyRivlinLaw::update_plane.
void update_plane(const MooneyRivlinLaw& law, const PlaneStep& step, PlaneLanes& stress,
                  std::span<Lanes> state);

/// By how much the plane is stiffer than that of the moduli: a strain across that costs nothing only lowers
/// the power, so that the bounds of the solid without stress across hold.
Lanes plane_stiffening(const MooneyRivlinLaw& law, std::span<const Lanes> state);

/// As NeoHookeanLaw::update_fibre; the stretch is the same all around, whatever the shear is.
void update_fibre(const NeoHookeanLaw& law, const FibreStep& step, FibreLanes& stress,
                  std::span<Lanes> state);

/// As plane_stiffening.
Lanes fibre_stiffening(const NeoHookeanLaw& law, std::span<const Lanes> state);

}  // namespace contactsim::hyperelastic

// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/neo_hookean.hpp"

#include "core/materials/thin_hyperelastic.hpp"

namespace contactsim {

void NeoHookeanLaw::start(std::span<Lanes> state) const { hyperelastic::start(state); }

LaneModuli NeoHookeanLaw::update(const StrainStep& step, SymmetricLanes& stress,
                                 std::span<Lanes> state) const {
  const SymmetricLanes b = hyperelastic::carry_along(step, state);
  const Lanes squared = hyperelastic::determinant(b), volume = squared.sqrt();
  const Lanes shear = moduli.shear * (-1.0 / 3.0 * squared.log()).exp();  // times J^(-2/3)
  const Lanes mean = shear * trace(b) / 3.0;
  stress = deviator(b);
  for (Lanes& component : stress.components) component *= shear;
  const Lanes deviation = contract(stress, stress).sqrt();
  const Lanes per_volume = 1.0 / volume;
  for (Lanes& component : stress.components) component *= per_volume;
  const Lanes pressure = 0.5 * moduli.bulk * (volume - per_volume);
  for (std::size_t i = 0; i < 3; ++i) stress[i] += pressure;
  return hyperelastic::tangent_bounds(moduli.bulk, volume, mean, deviation);
}

void NeoHookeanLaw::update_plane(const PlaneStep& step, PlaneLanes& stress, std::span<Lanes> state) const {
  hyperelastic::update_plane(MooneyRivlinLaw{moduli}, step, stress, state);
}

Lanes NeoHookeanLaw::plane_stiffening(std::span<const Lanes> state) const {
  return hyperelastic::plane_stiffening(MooneyRivlinLaw{moduli}, state);
}

void NeoHookeanLaw::update_fibre(const FibreStep& step, FibreLanes& stress, std::span<Lanes> state) const {
  hyperelastic::update_fibre(*this, step, stress, state);
}

Lanes NeoHookeanLaw::fibre_stiffening(std::span<const Lanes> state) const {
  return hyperelastic::fibre_stiffening(*this, state);
}

MaterialRow neo_hookean_material() {
  return {
      {"neo_hookean"},
      "Hyperelastic",
      {},
      {&law_kind<NeoHookeanLaw>},
      [](const MaterialInput& input) -> std::optional<MaterialLaw> { return NeoHookeanLaw{input.moduli()}; }};
}

}  // namespace contactsim

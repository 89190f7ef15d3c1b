// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/elastic.hpp"

#include "core/materials/elastic_stress.hpp"

namespace contactsim {

LaneModuli ElasticLaw::update(const StrainStep& step, SymmetricLanes& stress, std::span<Lanes>) const {
  stress = elastic_stress(moduli, step.strain, stress);
  return bounds_of(moduli);
}

void ElasticLaw::update_plane(const PlaneStep& step, PlaneLanes& stress, std::span<Lanes>) const {
  PlaneModuli(moduli).add(step.strain, stress);
}

void ElasticLaw::update_fibre(const FibreStep& step, FibreLanes& stress, std::span<Lanes>) const {
  stress[0] += moduli.youngs() * step.strain[0];
  for (std::size_t i = 1; i < 3; ++i) stress[i] += moduli.shear * step.strain[i];
}

MaterialRow elastic_material() {
  return {
      {"elastic"},
      "Hypoelastic, finite strain",
      {},
      {&law_kind<ElasticLaw>},
      [](const MaterialInput& input) -> std::optional<MaterialLaw> { return ElasticLaw{input.moduli()}; }};
}

MaterialRow linear_elastic_material() {
  return {
      {"linear_elastic"},
      "Linear elastic for small strain, run as elastic: both are the same while strains and turns are small",
      {},
      {&law_kind<ElasticLaw>},
      [](const MaterialInput& input) -> std::optional<MaterialLaw> {
        input.diagnostics.add_warning(
            "material-linear", {}, "linear_elastic is run as elastic, whose strains and turns may be large",
            "both are the same while they are small");
        return ElasticLaw{input.moduli()};
      }};
}

}  // namespace contactsim

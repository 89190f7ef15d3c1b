// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/mooney_rivlin.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "core/materials/thin_hyperelastic.hpp"

namespace contactsim {

namespace {

/// tr(B) B - B^2, whose trace is twice the second invariant.
SymmetricLanes second_tensor(const SymmetricLanes& b) {
  const TensorLanes rows{{{b[0], b[3], b[5]}, {b[3], b[1], b[4]}, {b[5], b[4], b[2]}}};
  SymmetricLanes tensor = squares(rows);
  const Lanes first = trace(b);
  for (std::size_t i = 0; i < 6; ++i) tensor[i] = first * b[i] - tensor[i];
  return tensor;
}

/// The bulk modulus that goes with a shear modulus and one more constant; of two constants, their own.
double bulk_of(const ElasticConstants& given, double shear) {
  ElasticConstants constants = given;
  const int n_given = given.n_given() - given.shear_modulus.has_value();
  if (n_given == 0) throw std::invalid_argument("nothing gives the bulk modulus; add BULK MODULUS");
  if (n_given == 1) constants.shear_modulus = shear;
  const double bulk = make_elastic_moduli(constants).bulk;
  const double other = make_elastic_moduli(constants).shear;
  constexpr double tolerance = 0.01;  // what constants that are written down may be rounded by
  const double said = given.shear_modulus.value_or(other);
  if (std::abs(said - shear) <= tolerance * shear) return bulk;
  throw std::invalid_argument(
      fmt::format("the elastic constants give a shear modulus of {}, C10 and C01 one of {}", said, shear));
}

}  // namespace

void MooneyRivlinLaw::start(std::span<Lanes> state) const { hyperelastic::start(state); }

/// The part of c01 bounds as that of c10, but for twice the largest eigenvalue of its deviator: with
/// A = J^(2/3) B^-1, m = 2/3 c01 tr A and s = -2 c01 dev A,
///   power = 2 m (D : D - tr^2 / 3) + 4/3 (s : D) tr - s : L L^T - 2 s : L L.
hyperelastic::Response MooneyRivlinLaw::at(const SymmetricLanes& b) const {
  const SymmetricLanes c = second_tensor(b);
  const Lanes squared = hyperelastic::determinant(b), volume = squared.sqrt(), per_volume = 1.0 / volume;
  const Lanes scale = (-1.0 / 3.0 * squared.log()).exp();  // J^(-2/3)
  const Lanes first = 2.0 * c10() * scale, second = 2.0 * c01 * scale * scale;
  SymmetricLanes stress, first_term = deviator(b), second_term = deviator(c);
  for (std::size_t i = 0; i < 6; ++i) {
    first_term[i] *= first;
    second_term[i] *= second;
    stress[i] = (first_term[i] + second_term[i]) * per_volume;
  }
  const Lanes pressure = 0.5 * moduli.bulk * (volume - per_volume);
  for (std::size_t i = 0; i < 3; ++i) stress[i] += pressure;

  const Lanes mean = ((first * trace(b) + 0.5 * second * trace(c)) / 3.0).max(0.0);
  const Lanes c01_norm = contract(second_term, second_term).sqrt();
  const Lanes deviation = contract(first_term, first_term).sqrt() + c01_norm;
  LaneModuli bounds = hyperelastic::tangent_bounds(moduli.bulk, volume, mean, deviation);
  const Lanes more = hyperelastic::largest_share * c01_norm * per_volume;
  bounds.shear += more;
  bounds.bulk += 2.0 / 3.0 * more;
  return {stress, bounds, mean * per_volume};
}

LaneModuli MooneyRivlinLaw::update(const StrainStep& step, SymmetricLanes& stress,
                                   std::span<Lanes> state) const {
  const hyperelastic::Response response = at(hyperelastic::carry_along(step, state));
  stress = response.stress;
  return response.bounds;
}

void MooneyRivlinLaw::update_plane(const PlaneStep& step, PlaneLanes& stress, std::span<Lanes> state) const {
  hyperelastic::update_plane(*this, step, stress, state);
}

Lanes MooneyRivlinLaw::plane_stiffening(std::span<const Lanes> state) const {
  return hyperelastic::plane_stiffening(*this, state);
}

MaterialRow mooney_rivlin_material() {
  return {{"mooney_rivlin"},
          "Hyperelastic, of two invariants",
          {parameter::real("c10", "Factor of the first invariant [force/length^2]").required(),
           parameter::real("c01", "Factor of the second invariant [force/length^2]").required()},
          {&law_kind<MooneyRivlinLaw>},
          [](const MaterialInput& input) -> std::optional<MaterialLaw> {
            const double c01 = input.values.real("c01"), shear = 2.0 * (input.values.real("c10") + c01);
            if (!(shear > 0.0)) throw std::invalid_argument("the sum of C10 and C01 must be positive");
            return MooneyRivlinLaw{{bulk_of(elastic_constants_of(input.values), shear), shear}, c01};
          },
          ElasticNeed::one_or_two};
}

}  // namespace contactsim

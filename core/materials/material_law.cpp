// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/material_law.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace contactsim {

namespace {

/// The bulk modulus that goes with a shear modulus and one more constant; of two constants, their own.
double bulk_of(const ElasticConstants& given, double shear) {
  ElasticConstants constants = given;
  const int n_given = given.youngs_modulus.has_value() + given.poissons_ratio.has_value() +
                      given.bulk_modulus.has_value() + given.lambda.has_value();
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

/// Makes laws of the models of the deck; throws std::invalid_argument with a text for the user. Nothing when
/// an error was added.
struct LawMaker {
  std::span<const FunctionDefinition> functions;
  Diagnostics& diagnostics;

  std::optional<MaterialLaw> operator()(const ElasticModel& model) const {
    return ElasticLaw{make_elastic_moduli(model.elastic)};
  }

  std::optional<MaterialLaw> operator()(const NeoHookeanModel& model) const {
    return NeoHookeanLaw{make_elastic_moduli(model.elastic)};
  }

  std::optional<MaterialLaw> operator()(const MooneyRivlinModel& model) const {
    const double shear = 2.0 * (model.c10 + model.c01);
    if (!(shear > 0.0)) throw std::invalid_argument("the sum of C10 and C01 must be positive");
    return MooneyRivlinLaw{{bulk_of(model.elastic, shear), shear}, model.c01};
  }

  std::optional<MaterialLaw> operator()(const OrthotropicModel& model) const {
    return make_orthotropic_law(model);
  }

  std::optional<MaterialLaw> operator()(const ElasticPlasticModel& model) const {
    const double modulus = model.hardening_modulus;
    const LinearHardening hardening{model.yield_stress, model.beta * modulus, (1.0 - model.beta) * modulus};
    const ElasticModuli moduli = make_elastic_moduli(model.elastic);
    if (!(3.0 * moduli.shear + modulus > 0.0)) {
      throw std::invalid_argument("the hardening modulus falls faster than three times the shear modulus");
    }
    return PlasticLaw<LinearHardening>{moduli, hardening};
  }

  std::optional<MaterialLaw> operator()(const PowerHardeningModel& model) const {
    return PlasticLaw<PowerHardening>{
        make_elastic_moduli(model.elastic),
        {model.yield_stress, model.hardening_constant, model.hardening_exponent, model.luders_strain}};
  }

  std::optional<MaterialLaw> operator()(const JohnsonCookModel& model) const {
    const PowerHardening power{model.yield_stress, model.hardening_constant, model.hardening_exponent};
    const PlasticLaw<JohnsonCookHardening> plastic{make_elastic_moduli(model.elastic),
                                                   {power, model.rate_constant, model.reference_rate}};
    // Without temperature the factor of d5 is 1.
    if (!model.d1 && !model.d2 && !model.d3 && !model.d4) return plastic;
    const JohnsonCookFailure failure{model.d1.value_or(0.0), model.d2.value_or(0.0), model.d3.value_or(0.0),
                                     model.d4.value_or(0.0), model.reference_rate};
    if (!(failure.strain(Lanes::Zero(), Lanes::Zero())(0) > 0.0))
      throw std::invalid_argument("d1 + d2, the failure strain in shear, must be positive");
    return FailingJohnsonCookLaw{plastic, failure};
  }

  std::optional<PlasticLaw<MultilinearHardening>> multilinear(const MultilinearModel& model) const {
    const ElasticModuli moduli = make_elastic_moduli(model.elastic);
    if (!(model.beta >= 0.0 && model.beta <= 1.0))
      throw std::invalid_argument(fmt::format("beta must be from 0 to 1, found {}", model.beta));
    auto curve =
        make_hardening_curve(model.hardening_function.value(), model.yield_stress, functions, diagnostics);
    if (!curve) return std::nullopt;
    return PlasticLaw<MultilinearHardening>{moduli, {std::move(*curve), model.beta}};
  }

  std::optional<MaterialLaw> operator()(const MultilinearModel& model) const { return multilinear(model); }

  std::optional<MaterialLaw> operator()(const TearingModel& model) const {
    auto plastic = multilinear(model.plastic);
    if (!plastic) return std::nullopt;
    return TearingLaw{std::move(*plastic), model.critical_tearing, model.critical_opening};
  }

  std::optional<MaterialLaw> voce(const J2Model& model) const {
    if (model.hardening_modulus < 0.0)
      throw std::invalid_argument(fmt::format("the hardening modulus of voce must not be negative, found {}",
                                              model.hardening_modulus));
    return PlasticLaw<VoceHardening>{
        make_elastic_moduli(model.elastic),
        {model.yield_stress, model.hardening_modulus, model.exponential_coefficient}};
  }

  std::optional<MaterialLaw> operator()(const J2Model& m) const {
    const HardeningModel kind = m.flow_stress().value();
    if (kind == HardeningModel::linear)
      return (*this)(ElasticPlasticModel{m.elastic, m.yield_stress, m.hardening_modulus, m.beta});
    if (kind == HardeningModel::user_defined)
      return (*this)(MultilinearModel{m.elastic, m.yield_stress, m.beta, m.hardening_function});
    if (m.beta != 1.0)
      throw std::invalid_argument("beta other than 1 goes with linear and user_defined hardening only");
    if (kind == HardeningModel::voce) return voce(m);
    return (*this)(PowerHardeningModel{m.elastic, m.yield_stress, m.hardening_constant, m.hardening_exponent,
                                       m.luders_strain});
  }

  /// Models that are bound but not integrated.
  template <class Model>
  std::optional<MaterialLaw> operator()(const Model&) const {
    throw std::invalid_argument(
        "the model is not supported; there are elastic, elastic_orthotropic, neo_hookean, mooney_rivlin, "
        "elastic_plastic, ep_power_hard, johnson_cook, multilinear_ep, ml_ep_fail, j2_plasticity");
  }
};

}  // namespace

LawState state_of(const MaterialLaw& law) {
  return std::visit(
      [](const auto& held) {
        using Law = std::decay_t<decltype(held)>;
        return LawState{Law::n_tensors, Law::n_state, Law::variables};
      },
      law);
}

ElasticModuli moduli_of(const MaterialLaw& law) {
  return std::visit([](const auto& held) { return held.moduli; }, law);
}

bool has_directions(const MaterialLaw& law) {
  return std::visit(
      [](const auto& held) {
        return requires { std::decay_t<decltype(held)>::n_vectors; };
      },
      law);
}

std::string_view failure_of(const MaterialLaw& law) {
  return std::visit(
      [](const auto& held) -> std::string_view {
        using Law = std::decay_t<decltype(held)>;
        if constexpr (requires { Law::failure; }) {
          return Law::failure;
        } else {
          return {};
        }
      },
      law);
}

bool can_be_plane(const MaterialLaw& law) {
  return std::visit(
      [](const auto& held) {
        return requires { &std::decay_t<decltype(held)>::update_plane; };
      },
      law);
}

bool can_be_fibre(const MaterialLaw& law) {
  return std::visit(
      [](const auto& held) {
        return requires { &std::decay_t<decltype(held)>::update_fibre; };
      },
      law);
}

void start_state(const MaterialLaw& law, std::span<Lanes> state) {
  std::visit([&](const auto& held) { held.start(state); }, law);
}

std::optional<MaterialLaw> make_material_law(const MaterialModel& model,
                                             std::span<const FunctionDefinition> functions,
                                             Diagnostics& diagnostics) {
  try {
    return std::visit(LawMaker{functions, diagnostics}, model.parameters);
  } catch (const std::invalid_argument& problem) {
    diagnostics.add_error(model.name.location, fmt::format("model '{}': {}", model.name.text, problem.what()),
                          "", static_cast<int>(model.name.text.size()));
    return std::nullopt;
  }
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/material_law.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace contactsim {

namespace {

/// Makes laws of the models of the deck; throws std::invalid_argument with a text for the user.
struct LawMaker {
  MaterialLaw operator()(const ElasticModel& model) const {
    return ElasticLaw{make_elastic_moduli(model.elastic)};
  }

  MaterialLaw operator()(const NeoHookeanModel& model) const {
    return NeoHookeanLaw{make_elastic_moduli(model.elastic)};
  }

  MaterialLaw operator()(const ElasticPlasticModel& model) const {
    const double modulus = model.hardening_modulus;
    const LinearHardening hardening{model.yield_stress, model.beta * modulus, (1.0 - model.beta) * modulus};
    const ElasticModuli moduli = make_elastic_moduli(model.elastic);
    if (!(3.0 * moduli.shear + modulus > 0.0)) {
      throw std::invalid_argument("the hardening modulus falls faster than three times the shear modulus");
    }
    return PlasticLaw<LinearHardening>{moduli, hardening};
  }

  MaterialLaw operator()(const PowerHardeningModel& model) const {
    return PlasticLaw<PowerHardening>{
        make_elastic_moduli(model.elastic),
        {model.yield_stress, model.hardening_constant, model.hardening_exponent, model.luders_strain}};
  }

  MaterialLaw operator()(const JohnsonCookModel& model) const {
    if (model.d1 || model.d2 || model.d3 || model.d4 || model.d5) {
      throw std::invalid_argument("failure of the model (d1 to d5) is not supported yet");
    }
    const PowerHardening power{model.yield_stress, model.hardening_constant, model.hardening_exponent};
    return PlasticLaw<JohnsonCookHardening>{make_elastic_moduli(model.elastic),
                                            {power, model.rate_constant, model.reference_rate}};
  }

  /// Models that are bound but not integrated.
  template <class Model>
  MaterialLaw operator()(const Model&) const {
    throw std::invalid_argument(
        "the model is not supported; there are elastic, neo_hookean, elastic_plastic, ep_power_hard, "
        "johnson_cook");
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

std::optional<MaterialLaw> make_material_law(const MaterialModel& model, Diagnostics& diagnostics) {
  try {
    return std::visit(LawMaker{}, model.parameters);
  } catch (const std::invalid_argument& problem) {
    diagnostics.add_error(model.name.location, fmt::format("model '{}': {}", model.name.text, problem.what()),
                          "", static_cast<int>(model.name.text.size()));
    return std::nullopt;
  }
}

}  // namespace contactsim

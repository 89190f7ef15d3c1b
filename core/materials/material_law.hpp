// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <variant>

#include "core/base/diagnostics.hpp"
#include "core/definition/material.hpp"
#include "core/materials/failing_johnson_cook.hpp"
#include "core/materials/laws.hpp"
#include "core/materials/mooney_rivlin.hpp"
#include "core/materials/neo_hookean.hpp"
#include "core/materials/orthotropic.hpp"
#include "core/materials/tearing.hpp"

namespace contactsim {

/// Every stress update there is.
using MaterialLaw =
    std::variant<ElasticLaw, NeoHookeanLaw, PlasticLaw<LinearHardening>, PlasticLaw<PowerHardening>,
                 PlasticLaw<JohnsonCookHardening>, MooneyRivlinLaw, OrthotropicLaw, FailingJohnsonCookLaw,
                 PlasticLaw<MultilinearHardening>, TearingLaw, PlasticLaw<VoceHardening>>;

/// What a law keeps per element and integration point.
struct LawState {
  std::size_t n_tensors = 0, n_state = 0;
  std::span<const StateVariable> variables;
};

LawState state_of(const MaterialLaw& law);

/// Elastic moduli of the law at rest.
ElasticModuli moduli_of(const MaterialLaw& law);

/// Whether the law has directions, which blocks have to give its state: Law::n_vectors.
bool has_directions(const MaterialLaw& law);

/// The state variable that reaches 1 where the law has failed by itself, Law::failure; empty of one that does
/// not fail.
std::string_view failure_of(const MaterialLaw& law);

/// Whether shells may be made of the law: it has update_plane.
bool can_be_plane(const MaterialLaw& law);

/// Whether beams and trusses may be: it has update_fibre.
bool can_be_fibre(const MaterialLaw& law);

/// Law::start of the law that is held.
void start_state(const MaterialLaw& law, std::span<Lanes> state);

/// The law of a model of the deck. Nothing when an error was added, at the model: it is not one that can be
/// integrated, or its constants give no stable material; or at its function: see make_hardening_curve.
///   functions  of the deck, that the model may name
std::optional<MaterialLaw> make_material_law(const MaterialModel& model,
                                             std::span<const FunctionDefinition> functions,
                                             Diagnostics& diagnostics);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/material_models.hpp"

#include <type_traits>

namespace contactsim {

const ElasticConstants* find_elastic_constants(const MaterialModel& model) {
  return std::visit(
      [](const auto& parameters) -> const ElasticConstants* {
        if constexpr (std::is_same_v<std::decay_t<decltype(parameters)>, OpaqueModel>) {
          return nullptr;
        } else if constexpr (std::is_same_v<std::decay_t<decltype(parameters)>, TearingModel>) {
          return &parameters.plastic.elastic;
        } else {
          return &parameters.elastic;
        }
      },
      model.parameters);
}

std::optional<DeckName> hardening_function_of(const MaterialModel& model) {
  return std::visit(
      [](const auto& parameters) -> std::optional<DeckName> {
        if constexpr (requires { parameters.hardening_function; }) {
          return parameters.hardening_function;
        } else if constexpr (requires { parameters.plastic.hardening_function; }) {
          return parameters.plastic.hardening_function;
        } else {
          return std::nullopt;
        }
      },
      model.parameters);
}

}  // namespace contactsim

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

const MultilinearModel* find_multilinear(const MaterialModel& model) {
  const auto* tearing = std::get_if<TearingModel>(&model.parameters);
  return tearing != nullptr ? &tearing->plastic : std::get_if<MultilinearModel>(&model.parameters);
}

}  // namespace contactsim

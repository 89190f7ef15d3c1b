// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/material.hpp"

namespace contactsim {

const MaterialModel* find_model(const MaterialDefinition& material, std::string_view name) {
  const std::string wanted = fold(name);
  for (const MaterialModel& model : material.models) {
    if (fold(model.name.text) == wanted) return &model;
  }
  return nullptr;
}

}  // namespace contactsim

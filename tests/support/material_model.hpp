// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string>
#include <utility>

#include "core/materials/material_table.hpp"

namespace contactsim::test {

/// A model of the table as a deck would give it: its name, and values by their phrases.
inline MaterialModel material_model(
    const std::string& name, std::initializer_list<std::pair<const char*, ParameterValue>> given = {}) {
  MaterialModel model{{name, {}}, ParameterValues(find_material_row(name)->parameters)};
  for (const auto& [phrase, value] : given) model.values.set(phrase, value);
  return model;
}

}  // namespace contactsim::test

// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/friction.hpp"

#include <algorithm>
#include <vector>

#include "core/definition/built_in_friction.hpp"

namespace contactsim {

namespace {

/// The laws of built_in_friction, in its order.
const std::vector<FrictionLaw>& built_in_laws() {
  static const std::vector<FrictionLaw> laws = [] {
    std::vector<FrictionLaw> made;
    for (const BuiltInFriction& built_in : built_in_friction) made.push_back({std::string(built_in.law)});
    return made;
  }();
  return laws;
}

}  // namespace

const FrictionLaw* find_friction_law(std::span<const FrictionModel> models, std::string_view name) {
  const std::string wanted = fold(name);
  for (const FrictionModel& model : models) {
    if (fold(model.name.text) == wanted) return &model.law;
  }
  const auto found = std::ranges::find(built_in_friction, wanted, &BuiltInFriction::name);
  if (found == built_in_friction.end()) return nullptr;
  return &built_in_laws()[static_cast<std::size_t>(found - built_in_friction.begin())];
}

}  // namespace contactsim

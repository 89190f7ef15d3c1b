// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/friction.hpp"

namespace contactsim {

const FrictionLaw* find_friction_law(std::span<const FrictionModel> models, std::string_view name) {
  static const FrictionLaw frictionless{"frictionless"}, tied{"tied"};
  const std::string wanted = fold(name);
  for (const FrictionModel& model : models) {
    if (fold(model.name.text) == wanted) return &model.law;
  }
  if (wanted == "frictionless") return &frictionless;
  return wanted == "tied" ? &tied : nullptr;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/friction.hpp"

namespace contactsim {

const FrictionLaw* find_friction_law(std::span<const FrictionModel> models, std::string_view name) {
  static const FrictionLaw frictionless = Frictionless{}, tied = Tied{};
  const std::string wanted = fold(name);
  for (const FrictionModel& model : models) {
    if (fold(model.name.text) == wanted) return &model.law;
  }
  if (wanted == "frictionless") return &frictionless;
  return wanted == "tied" ? &tied : nullptr;
}

std::shared_ptr<const FrictionLaw> share_law(FrictionLaw law) {
  return std::make_shared<const FrictionLaw>(std::move(law));
}

}  // namespace contactsim

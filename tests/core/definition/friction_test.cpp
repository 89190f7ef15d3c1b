// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/friction.hpp"

#include <vector>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("friction laws are found by name, without case", "[core][friction]") {
  const std::vector<FrictionModel> models{{{"Rub", {}}, ConstantFriction{0.3}}, {{"rub", {}}, Glued{}}};
  const FrictionLaw* law = find_friction_law(models, "RUB");
  REQUIRE(law != nullptr);
  CHECK(std::get<ConstantFriction>(*law).coefficient == 0.3);
  CHECK(find_friction_law(models, "rob") == nullptr);
}

TEST_CASE("frictionless and tied are there without a definition, which may replace them",
          "[core][friction]") {
  CHECK(std::holds_alternative<Frictionless>(*find_friction_law({}, "FrictionLess")));
  CHECK(std::holds_alternative<Tied>(*find_friction_law({}, "tied")));
  const std::vector<FrictionModel> models{{{"tied", {}}, Glued{}}};
  CHECK(std::holds_alternative<Glued>(*find_friction_law(models, "tied")));
}

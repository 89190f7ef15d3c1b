// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/friction.hpp"

#include <vector>

#include "support/catch.hpp"
#include "support/friction_law.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("friction laws are found by name, without case", "[core][friction]") {
  const std::vector<FrictionModel> models{{{"Rub", {}}, coulomb(0.3)}, {{"rub", {}}, friction_law("glued")}};
  const FrictionLaw* law = find_friction_law(models, "RUB");
  REQUIRE(law != nullptr);
  CHECK(law->values.real("friction coefficient") == 0.3);
  CHECK(find_friction_law(models, "rob") == nullptr);
}

TEST_CASE("frictionless and tied are there without a definition, which may replace them",
          "[core][friction]") {
  CHECK(find_friction_law({}, "FrictionLess")->type == "frictionless");
  CHECK(find_friction_law({}, "tied")->type == "tied");
  CHECK(find_friction_law({}, "STICK")->type == "stick");
  CHECK(find_friction_law({}, "freeze")->type == "tied");
  const std::vector<FrictionModel> models{{{"tied", {}}, friction_law("glued")}};
  CHECK(find_friction_law(models, "tied")->type == "glued");
}

// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/material.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a model is found by its name in any case, the first of a name", "[core][definition]") {
  const MaterialDefinition steel{
      {"steel", {}}, 7800.0, {{{"Elastic", {}}, {}}, {{"ml ep fail", {}}, {}}, {{"elastic", {}}, {}}}};
  CHECK(find_model(steel, "ELASTIC") == &steel.models[0]);
  CHECK(find_model(steel, "ML_EP_FAIL") == &steel.models[1]);  // a blank is an underscore
  CHECK(find_model(steel, "elasti") == nullptr);
  CHECK(find_model({}, "elastic") == nullptr);
}

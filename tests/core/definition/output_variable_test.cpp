// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/output_variable.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a variable goes to the file under its alias, else under its own name", "[core][output]") {
  VariableRequest request;
  request.variable.name.text = "Kinetic_Energy";
  CHECK(output_name(request) == "Kinetic_Energy");
  request.alias = "KE";
  CHECK(output_name(request) == "KE");
}

TEST_CASE("older spellings of variables are known", "[core][output]") {
  CHECK(canonical_variable_name("KineticEnergy") == "kinetic_energy");
  CHECK(canonical_variable_name("reactions") == "reaction");
  CHECK(canonical_variable_name("Von_Mises") == "von_mises");
}

// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/explain_variables.hpp"

#include <vector>

#include "core/materials/material_table.hpp"
#include "support/catch.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::explain_variables;
using contactsim::LawKind;
using contactsim::material_laws;
using contactsim::StateVariable;
using contactsim::test::ProgramDirectory;

namespace {

std::string explained(const std::vector<std::string>& words) { return explain_variables(words); }

}  // namespace

TEST_CASE("output variables are explained by their rows", "[app][explain]") {
  CHECK_THAT(explained({"von", "Mises"}), Contains("  element  von_mises ") && !Contains("velocity"));
  CHECK_THAT(explained({"velocity"}), Contains("  nodal    velocity(3) ") && Contains("[length/time]"));
  CHECK(explained({"no such thing"}) == "");
  const std::string all = explained({"output", "variables"});
  CHECK_THAT(all, Contains("kinetic_energy") && Contains("displacement(3)") && Contains("stress(6)") &&
                      Contains("eqps"));
}

TEST_CASE("every variable that some material keeps is explained", "[app][explain]") {
  const std::string all = explained({"output", "variables"});
  for (const LawKind* law : material_laws()) {
    for (const StateVariable& variable : law->variables)
      CHECK_THAT(all, Contains(std::string(variable.name)) && Contains(std::string(variable.help)));
  }
  CHECK_THAT(all, Contains("tearing_parameter") && Contains("left_cauchy_green(6)"));
}

TEST_CASE("explain finds a variable where no command is so called", "[app][explain]") {
  const auto [code, out, err] = ProgramDirectory().run({"explain", "eqps"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("equivalent plastic strain [1]"));
}

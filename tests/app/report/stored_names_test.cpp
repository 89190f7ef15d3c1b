// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/stored_names.hpp"

#include "core/definition/simulation.hpp"
#include "support/catch.hpp"
#include "support/report_region.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("without a deck names on a file are those of contactsim", "[app][report]") {
  const StoredNames names;
  CHECK(names.variable_of("von_mises") == "von_mises");
  CHECK(names.variable_of("") == "");
  CHECK(names.on_file("von_mises") == std::vector<std::string>{"von_mises"});
}

TEST_CASE("names of all results outputs stand for their variables, in any case", "[app][report]") {
  const SimulationDefinition deck = deck_of_region(
      "begin results output\ndatabase name = a.e\nat step 0 increment = 1\nelement von_mises as Mises\n"
      "nodal displacement\nend\nbegin results output\ndatabase name = b.e\nat step 0 increment = 1\n"
      "element von_mises as seqv\nelement eqps as mises\nend");
  const StoredNames names(region_of(deck));
  CHECK(names.variable_of("MISES") == "von_mises");  // the first of a name counts
  CHECK(names.variable_of("seqv") == "von_mises");
  CHECK(names.variable_of("displacement") == "displacement");
  CHECK(names.on_file("von_mises") == std::vector<std::string>{"mises", "seqv", "von_mises"});
  CHECK(names.on_file("death_status") == std::vector<std::string>{"death_status"});
}

// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/output_variable_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

std::vector<VariableRequest> results_of(const std::string& lines) {
  const BoundRegion bound = bound_region("begin results output\n" + lines + "end\n");
  CHECK(bound.messages == "");
  return bound.region.results_outputs.at(0).variables;
}

std::vector<VariableRequest> history_of(const std::string& lines) {
  const BoundRegion bound = bound_region("begin history output\n" + lines + "end\n");
  CHECK(bound.messages == "");
  return bound.region.history_outputs.at(0).variables;
}

std::string history_messages(const std::string& line) {
  return bound_region("begin history output\n" + line + "\nend\n").messages;
}

}  // namespace

TEST_CASE("every location of variables is read", "[parser][output]") {
  const auto [words, location] = GENERATE(table<std::string, VariableLocation>({
      {"variables = ", VariableLocation::any},
      {"global variables = ", VariableLocation::global},
      {"global ", VariableLocation::global},
      {"nodal variables = ", VariableLocation::nodal},
      {"node variables ", VariableLocation::nodal},
      {"nodal ", VariableLocation::nodal},
      {"node ", VariableLocation::nodal},
      {"element variables = ", VariableLocation::element},
      {"element ", VariableLocation::element},
      {"edge variables = ", VariableLocation::edge},
      {"face variables = ", VariableLocation::face},
      {"nodeset variables = ", VariableLocation::node_set},
      {"node set variables = ", VariableLocation::node_set},
      {"surface variables = ", VariableLocation::side_set},
      {"sideset variables = ", VariableLocation::side_set},
  }));
  const auto requests = results_of(words + "v AS KineticEnergy\n");
  REQUIRE(requests.size() == 1);
  CHECK(requests[0].location == location);
  CHECK(requests[0].variable.name.text == "v");
  CHECK(requests[0].alias == "KineticEnergy");
  CHECK(std::holds_alternative<WholeModel>(requests[0].place));
}

TEST_CASE("a line asks for several variables, each with or without alias", "[parser][output]") {
  const auto requests = results_of("nodal variables = displacement as displ velocity force_contact as f\n");
  REQUIRE(requests.size() == 3);
  CHECK(output_name(requests[0]) == "displ");
  CHECK(output_name(requests[1]) == "velocity");
  CHECK(requests[2].variable.name.text == "force_contact");
  CHECK(output_name(requests[2]) == "f");
}

TEST_CASE("a request may name a component and an integration point", "[parser][output]") {
  const auto requests = results_of("element variables = stress(xx, 1) as s11 eqps(:,2)\n");
  REQUIRE(requests.size() == 2);
  CHECK(requests[0].variable.component == "xx");
  CHECK(requests[0].variable.integration_point == 1);
  CHECK(requests[1].variable.component == "");
  CHECK(requests[1].variable.integration_point == 2);
}

TEST_CASE("a variable may be restricted to parts, which run to the end of the line", "[parser][output]") {
  const auto requests = results_of(
      "element variables = eqps stress as s include block_1 block_2\nface variables = contact_status on "
      "surface_1\n"
      "nodeset variables = displacement exclude nodelist_4\n");
  REQUIRE(requests.size() == 4);
  CHECK(std::holds_alternative<WholeModel>(requests[0].place));
  CHECK(joined_names(std::get<NamedParts>(requests[1].place).names) == "block_1 block_2");
  CHECK_FALSE(std::get<NamedParts>(requests[1].place).are_excluded);
  CHECK(joined_names(std::get<NamedParts>(requests[2].place).names) == "surface_1");
  CHECK(std::get<NamedParts>(requests[3].place).are_excluded);
}

TEST_CASE("history asks for single entities by id or by place", "[parser][output]") {
  const auto requests = history_of(
      "node displacement(x) at node 42 as dx42\nnodal velocity as v at nodal 7\nelement stress at element 3 "
      "as s\n"
      "node displacement nearest location 1.0, 2.0, 3.0 as d\nglobal kinetic_energy as KE\nglobal "
      "timestep\n");
  REQUIRE(requests.size() == 6);
  CHECK(requests[0].location == VariableLocation::nodal);
  CHECK(std::get<SingleEntity>(requests[0].place).id == 42);
  CHECK(to_string(std::get<SingleEntity>(requests[0].place).location) == "a.i:2:30");
  CHECK(requests[0].alias == "dx42");
  CHECK(std::get<SingleEntity>(requests[1].place).id == 7);
  CHECK(requests[1].alias == "v");
  CHECK(requests[2].location == VariableLocation::element);
  CHECK(std::get<NearestEntity>(requests[3].place).point == Eigen::Vector3d(1.0, 2.0, 3.0));
  CHECK(requests[3].alias == "d");
  CHECK(requests[4].alias == "KE");
  CHECK(output_name(requests[5]) == "timestep");
}

TEST_CASE("the older history form is taken", "[parser][output]") {
  const auto requests =
      history_of("variable = node displacement at node 42 as d\nvariable = global timestep\n");
  REQUIRE(requests.size() == 2);
  CHECK(requests[0].location == VariableLocation::nodal);
  CHECK(std::get<SingleEntity>(requests[0].place).id == 42);
  CHECK(requests[0].alias == "d");
  CHECK(requests[1].location == VariableLocation::global);
}

TEST_CASE("the kind of a variable and of the place where it is read must agree", "[parser][output]") {
  CHECK(history_messages("node displacement at element 3") ==
        "a.i:2:22: error: 'displacement' cannot be read at a element; the two kinds of the line "
        "must agree: NODE v AT NODE 42\n");
  CHECK(history_messages("global timestep at global 3") ==
        "a.i:2:20: error: 'timestep' cannot be read at a global; the two kinds of the line must "
        "agree: NODE v AT NODE 42\n");
  CHECK(history_messages("node displacement at node 0") ==
        "a.i:2:27: error: 'node' must be at least 1, found '0'\n");
  CHECK(history_messages("node displacement at") ==
        "a.i:2:1: error: expected an entity such as NODE 42 after 'at'\n");
  CHECK(history_messages("node displacement nearest location 1 2") ==
        "a.i:2:1: error: expected a number after 'node', found the end of the line\n");
}

TEST_CASE("results are of the whole model, not of single nodes", "[parser][output]") {
  CHECK(bound_region("begin results output\nnode displacement at node 3\nend\n").messages ==
        "a.i:2:19: error: single nodes and elements are for HISTORY and HEARTBEAT OUTPUT\n");
}

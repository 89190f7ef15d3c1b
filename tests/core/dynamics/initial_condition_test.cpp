// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/initial_condition.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/two_rows.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// What INITIAL CONDITION blocks with these lines say, one after the other, the run starting at 2.
struct SetConditions {
  InitialState state;
  std::string messages;

  explicit SetConditions(const std::vector<std::string>& conditions) {
    std::string lines;
    for (const std::string& condition : conditions)
      lines += "begin initial condition\n" + condition + "\nend\n";
    const StoredVariables stored = stored_results();
    ConditionDeck deck(two_rows(), lines, 2.0, &stored);
    const std::vector<ModelBlock> blocks = blocks_of_two_rows();
    const auto n_nodes = static_cast<Eigen::Index>(two_rows().n_nodes());
    state.velocity = state.displacement = Eigen::Matrix3Xd::Constant(3, n_nodes, -1.0);
    const ConditionScope scope = deck.scope();
    InitialConditionSetter setter(scope, blocks, state);
    for (const InitialCondition& condition : deck.region().initial_conditions) setter.set(condition);
    messages = deck.messages();
  }
};

bool is_of_first_block(std::uint32_t node) { return two_rows().coordinates()(1, node) < 2.0; }

}  // namespace

TEST_CASE("initial conditions that cannot be met are errors", "[core][conditions]") {
  const auto messages = [](const std::string& lines) { return SetConditions({lines}).messages; };
  CHECK(messages(nodal("velocity") + "magnitude = 1") ==
        "c.i:4:28: error: 'velocity' needs 3 numbers for MAGNITUDE, found 1\n");
  CHECK(messages(nodal("velocity(w)") + "magnitude = 1") ==
        "c.i:4:28: error: 'velocity' has no component 'w'\n");
  CHECK(messages(nodal("pressure") + "magnitude = 1") ==
        "c.i:4:28: error: nodes have no 'pressure' that could be set at the start; velocity and displacement "
        "can\n");
  CHECK(messages(elemental("eqp") + "magnitude = 1") ==
        "c.i:4:28: error: elements have no 'eqp' that could be set at the start; they have stress, eqps, "
        "back_stress\n");
  CHECK(messages(elemental("eqps", "block_2") + "magnitude = 1") ==
        "c.i:4:28: error: the material of 'block_2' has no 'eqps'\n");
  CHECK(messages(elemental("stress(xx)", "block_2") + "read variable = e") ==
        "c.i:4:28: error: the initial 'stress(xx)' is not finite, or missing, at element 10\n");
  CHECK(messages(nodal("velocity") + "read variable = speed") ==
        "c.i:5:17: error: the mesh file has no nodal variable 'speed' with 3 components\n");
  CHECK(messages("variable type = global\ninitialize variable name = x\nmagnitude = 1") ==
        "c.i:1:1: error: the initial condition is not of a node or element variable, which it must be; write "
        "VARIABLE TYPE = NODE or ELEMENT\n");
  CHECK(messages(nodal("temperature") + "magnitude = 1") ==
        "c.i:4:28: warning: the initial temperature has no effect: nothing depends on it "
        "[condition-ignored]\n");
  CHECK(messages("surface = surface_1\nvariable type = element\ninitialize variable name = stress(xx)\n"
                 "magnitude = 1") == "c.i:2:11: error: the mesh has no side set 'surface_1'\n");
}

TEST_CASE("a condition of nodes sets those of its blocks, all components or the one that is picked",
          "[core][conditions]") {
  const SetConditions set({nodal("velocity") + "magnitude = 1 2 3", nodal("velocity(z)") + "magnitude = 9",
                           nodal("displacement(x)") + "magnitude = 0.5"});
  CHECK(set.messages.empty());
  for (std::uint32_t node = 0; node < two_rows().n_nodes(); ++node) {
    const bool is_in = is_of_first_block(node);
    CHECK(set.state.velocity.col(node) == (is_in ? Vector3d(1, 2, 9) : Vector3d(-1, -1, -1)));
    CHECK(set.state.displacement.col(node) == Vector3d(is_in ? 0.5 : -1.0, -1, -1));
  }
  CHECK(set.state.element_values.empty());
}

TEST_CASE("a condition of elements names its variable and component, and leaves other elements alone",
          "[core][conditions]") {
  const SetConditions set({elemental("stress(zz)") + "magnitude = -7", elemental("EQPS") + "magnitude = 0.1",
                           elemental("back_stress", "block_1") + "magnitude = 1 2 3 4 5 6"});
  CHECK(set.messages.empty());
  REQUIRE(set.state.element_values.size() == 1 + 1 + 6);
  CHECK(set.state.element_values[0].variable == "stress");
  CHECK(set.state.element_values[0].component == 2);
  CHECK(set.state.element_values[1].variable == "eqps");
  for (std::size_t k = 0; k < 6; ++k) {
    CHECK(set.state.element_values[2 + k].variable == "back_stress");
    CHECK(set.state.element_values[2 + k].component == k);
    CHECK(set.state.element_values[2 + k].values[8] == static_cast<double>(k + 1));
  }
  for (const InitialElementValues& values : set.state.element_values) {
    REQUIRE(values.values.size() == 10);
    CHECK(std::isnan(values.values[9]));  // of the second block
  }
  CHECK(set.state.element_values[0].values[0] == -7.0);
}

TEST_CASE("what is read is scaled and that of each node or element, MAGNITUDE is not scaled",
          "[core][conditions]") {
  const SetConditions set({nodal("velocity(y)") + "read variable = p\ntime = 1\nscale factor = 2",
                           elemental("stress") + "read variable = s\nscale factor = -1",
                           nodal("displacement(x)") + "magnitude = 4\nscale factor = 3"});
  CHECK(set.messages.empty());
  for (std::uint32_t node = 0; node < two_rows().n_nodes(); ++node) {
    if (!is_of_first_block(node)) continue;
    CHECK(set.state.velocity(1, node) == 2.0 * (node + 10.0));
    CHECK(set.state.displacement(0, node) == 4.0);
  }
  REQUIRE(set.state.element_values.size() == 6);
  for (const InitialElementValues& values : set.state.element_values) {
    for (std::size_t element = 0; element < 9; ++element)
      CHECK(values.values[element] == -static_cast<double>(element));
  }
}

TEST_CASE("a temperature is told to have no effect, whatever else its condition says", "[core][conditions]") {
  const SetConditions set(
      {"block = block_9\nvariable type = global\ninitialize variable name = "
       "Temperature\nmagnitude = 1 2"});
  CHECK_THAT(set.messages, Catch::Matchers::Contains("[condition-ignored]"));
  CHECK(std::count(set.messages.begin(), set.messages.end(), '\n') == 1);
}

TEST_CASE("a wrong value sets nothing of its elements, and those behind it go on", "[core][conditions]") {
  const SetConditions set({elemental("stress(xx)", "block_2") + "read variable = e",
                           elemental("stress(xx)") + "read variable = e"});
  CHECK_THAT(set.messages, Catch::Matchers::Contains("at element 10"));
  REQUIRE(set.state.element_values.size() == 1);
  CHECK(set.state.element_values[0].values[3] == 3.0);
}

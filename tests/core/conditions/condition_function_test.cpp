// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/condition_function.hpp"
#include "core/definition/simulation.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/function_definition.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using Variables = std::vector<std::pair<ExpressionSource, std::string>>;

/// The value at node 1 and time 5 of "expression" with variables a, b, ...; the node stood at (0 0 0), stands
/// at (1 2 3) and moves at (7 8 9).
struct Value {
  Value(const std::string& expression, const Variables& variables) {
    const Mesh mesh = MeshBuilder().add_hexes({}).build();
    SimulationDefinition definition;
    definition.functions = {analytic_function(expression)};
    std::string name = "a";
    for (const auto& [source, variable] : variables) {
      definition.functions[0].variables.push_back({{name, {}}, source, {variable, {}}});
      ++name[0];
    }
    const Region region;
    Diagnostics diagnostics;
    const ConditionScope scope{definition, region, {}, mesh, diagnostics};
    const auto function = make_condition_function({DeckName{"f", {}}, 2.0}, {"the test", {}}, scope);
    messages = contactsim::messages(diagnostics);
    if (!function) return;
    const Eigen::Matrix3Xd x = Eigen::Vector3d(1, 2, 3).replicate(1, 8);
    const Eigen::Matrix3Xd v = Eigen::Vector3d(7, 8, 9).replicate(1, 8);
    varies = function->varies_in_space();
    value = function->at(5.0, {mesh.coordinates(), x, v}, {0});
  }

  double value = 0.0;
  bool varies = false;
  std::string messages;
};

}  // namespace

TEST_CASE("a condition's function reads the time or the fields of a node", "[core][conditions]") {
  using S = ExpressionSource;
  CHECK(Value("x + 1", {}).value == 12.0);
  CHECK_FALSE(Value("x + 1", {}).varies);
  CHECK(Value("a", {{S::nodal, "coordinates(z)"}}).value == 6.0);
  CHECK(Value("a", {{S::nodal, "Coordinates(2)"}}).varies);
  CHECK(Value("a + 10*b + 100*c",
              {{S::nodal, "displacement(y)"}, {S::global, "time"}, {S::nodal, "velocity(x)"}})
            .value == 2.0 * (2 + 50 + 700));
  CHECK(Value("a_x - b_z", {{S::nodal_vector, "velocity"}, {S::nodal_vector, "model_coordinates"}}).value ==
        14.0);
}

TEST_CASE("what a condition does not know cannot be read", "[core][conditions]") {
  using S = ExpressionSource;
  const std::string rest =
      ", which conditions do not know; they know the global time and x, y and z of the nodal coordinates, "
      "model_coordinates, displacement and velocity\n";
  CHECK(Value("a", {{S::nodal, "temperature"}}).messages ==
        "error: the function of the test reads 'temperature'" + rest);
  CHECK(Value("a", {{S::nodal, "coordinates"}}).messages ==
        "error: the function of the test reads 'coordinates'" + rest);
  CHECK(Value("a", {{S::global, "timestep"}}).messages ==
        "error: the function of the test reads 'timestep'" + rest);
  CHECK(Value("a", {{S::element, "coordinates(x)"}}).messages ==
        "error: the function of the test reads 'coordinates(x)'" + rest);
  CHECK(Value("a_x", Variables(6, {S::nodal_vector, "velocity"})).messages ==
        "error: the function of the test reads more than 16 numbers\n");
}

// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/variable_selection.hpp"

#include "support/catch.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using L = VariableLocation;

std::optional<VariableSelection> selection(const OutputVariables& variables, const VariableRequest& request) {
  Diagnostics diagnostics;
  return find_selection(variables, request.location, request.variable, diagnostics);
}

/// The warning about a variable and its hint.
std::string warning(const OutputVariables& variables, const VariableRequest& request) {
  Diagnostics diagnostics;
  CHECK_FALSE(find_selection(variables, request.location, request.variable, diagnostics));
  REQUIRE(diagnostics.all().size() == 1);
  CHECK(diagnostics.all()[0].severity == Severity::warning);
  CHECK(diagnostics.all()[0].id == "output-variable-unknown");
  return diagnostics.all()[0].text + "; " + diagnostics.all()[0].hint;
}

}  // namespace

TEST_CASE("variables are found by name, older spelling, component", "[core][output]") {
  const SampleRun run;
  const OutputVariables variables(run.model);
  CHECK(selection(variables, request(L::nodal, "Velocity"))->n_components() == 3);
  CHECK(selection(variables, request(L::global, "kineticenergy"))->variable->name == "kinetic_energy");
  CHECK(selection(variables, request(L::nodal, "velocity", "y"))->component == 1);
  CHECK(selection(variables, request(L::element, "stress", "zx"))->component == 5);
  CHECK(selection(variables, request(L::element, "stress", "xz"))->component == 5);
  CHECK(selection(variables, request(L::element, "stress", "4"))->component == 3);
  CHECK(selection(variables, request(L::element, "principal_stresses", "3"))->component == 2);
  CHECK(selection(variables, request(L::nodal, "velocity", "magnitude"))->n_components() == 1);
  CHECK(selection(variables, request(L::any, "von_mises"))->variable->location == FieldLocation::element);
  CHECK(selection(variables, request(L::element, "strain_energy"))->variable->location ==
        FieldLocation::element);
}

TEST_CASE("values of single entities are those of all", "[core][output]") {
  SampleRun run;
  run.deform(1.1 * Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Constant(0.5));
  const OutputVariables variables(run.model);
  for (const char* component : {"", "y"}) {
    const VariableSelection chosen = selection(variables, request(L::nodal, "velocity", component)).value();
    const std::size_t n = chosen.n_components();
    std::vector<double> all(run.mesh.n_nodes() * n);
    fill(chosen, run.context(), {0, 0, run.mesh.n_nodes(), {}}, all);
    const std::vector<std::uint32_t> nodes{7, 8, 9, 3, 4, 40, 39, 0};
    std::vector<double> some(nodes.size() * n);
    fill(chosen, run.context(), 0, nodes, some);
    for (std::size_t i = 0; i < some.size(); ++i) CHECK(some[i] == all[nodes[i / n] * n + i % n]);
  }
}

TEST_CASE("what is unknown is a warning that helps", "[core][output]") {
  const SampleRun run;
  const OutputVariables variables(run.model);
  CHECK(warning(variables, request(L::nodal, "velocty")) ==
        "no nodal variable 'velocty' is known here; did you mean 'velocity'?");
  CHECK(warning(variables, request(L::any, "memb_stress")) ==
        "no variable 'memb_stress' is known here; shells have it");
  CHECK(warning(variables, request(L::nodal, "Velocity_x")) ==
        "no nodal variable 'Velocity_x' is known here; did you mean velocity(x)?");
  CHECK(warning(variables, request(L::any, "stress_xz")) ==
        "no variable 'stress_xz' is known here; did you mean stress(xz)?");
  CHECK(warning(variables, request(L::global, "x")) == "no global variable 'x' is known here; ");
  CHECK(warning(variables, request(L::nodal, "stress")) ==
        "'stress' is no nodal variable; did you mean element stress?");
  CHECK(warning(variables, request(L::face, "pressure")) ==
        "'pressure': variables of edges, faces and sets are not written; ");
  CHECK(warning(variables, request(L::nodal, "velocity", "xx")) ==
        "velocity has no component 'xx'; its components are x y z magnitude");
  CHECK(warning(variables, request(L::nodal, "velocity", "0")) ==
        "velocity has no component '0'; its components are x y z magnitude");
  CHECK(warning(variables, request(L::nodal, "mass", "x")) ==
        "mass has no component 'x'; it has one component");
}

TEST_CASE("materials have their variables, in their blocks alone", "[core][output]") {
  SampleRun run;
  const OutputVariables variables(run.model);
  const auto eqps = selection(variables, request(L::element, "eqps"));
  REQUIRE(eqps);
  CHECK_FALSE(eqps->is_in_block(run.model, 0));
  CHECK(eqps->is_in_block(run.model, 1));
  const std::size_t place = run.model.blocks[1].properties.law.kind().n_state - 1;
  run.set_point_value(1, 1, 6 + place, 0.25);
  std::vector<double> values(2, -1.0);
  fill(*eqps, run.context(), {1, 0, 2, {}}, values);
  CHECK(values == std::vector<double>{0.0, 0.25});
}

TEST_CASE("a material may be asked for at an integration point", "[core][output]") {
  const SampleRun run;
  const OutputVariables variables(run.model);
  VariableRequest stress = request(L::element, "stress", "xx");
  stress.variable.integration_point = 1;
  CHECK(selection(variables, stress)->point == 0);
  stress.variable.integration_point = 9;
  CHECK(warning(variables, stress) == "stress has no integration point 9; ");
}

TEST_CASE("long ranges are filled in pieces, one component alike", "[core][output]") {
  const Mesh mesh;
  Model model;
  model.mesh = &mesh;
  const State state;
  const OutputVariable counting{"counting",
                                FieldLocation::node,
                                FieldShape::vector,
                                3,
                                false,
                                {},
                                [](const OutputContext&, const EntityRange& range, std::span<double> values) {
                                  for (std::size_t i = 0; i < values.size(); ++i)
                                    values[i] = static_cast<double>(3 * range.first + i);
                                }};
  constexpr std::size_t n = 2500;
  std::vector<double> values(3 * n);
  fill({&counting, {}, {}}, {model, state}, {0, 10, n, {}}, values);
  std::size_t n_wrong = 0;
  for (std::size_t i = 0; i < 3 * n; ++i) n_wrong += values[i] != 30.0 + static_cast<double>(i);
  CHECK(n_wrong == 0);
  fill({&counting, 1, {}}, {model, state}, {0, 10, n, {}}, std::span(values).first(n));
  for (std::size_t i = 0; i < n; ++i) n_wrong += values[i] != 31.0 + 3.0 * static_cast<double>(i);
  CHECK(n_wrong == 0);
}

TEST_CASE("a variable that the deck makes hides an earlier one", "[core][output]") {
  const SampleRun run;
  OutputVariables variables(run.model);
  OutputVariable own;
  own.name = "momentum";
  variables.add(own);
  CHECK(variables.find(FieldLocation::global, "momentum")->shape == FieldShape::scalar);
  CHECK(variables.find(FieldLocation::node, "momentum") == nullptr);
}

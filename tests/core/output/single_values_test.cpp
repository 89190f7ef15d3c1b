// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/single_values.hpp"

#include <memory>

#include "support/catch.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace single_values_test {

namespace {

using L = VariableLocation;
using Names = std::vector<std::string>;

struct Outcome {
  std::shared_ptr<const OutputVariables> variables;
  RequestedFields fields;
  Names messages;
};

Outcome ask(const SampleRun& run, const std::vector<VariableRequest>& requests) {
  const auto variables = std::make_shared<const OutputVariables>(run.model);
  Diagnostics diagnostics;
  Outcome outcome{variables, make_single_values(*variables, requests, "_", diagnostics), {}};
  for (const Diagnostic& found : diagnostics.all())
    outcome.messages.push_back((found.severity == Severity::error ? "error: " : "") + found.text);
  return outcome;
}

VariableRequest at(VariableRequest request, std::int64_t id) {
  request.place = SingleEntity{id, {}};
  return request;
}

VariableRequest nearest(VariableRequest request, double x, double y, double z) {
  request.place = NearestEntity{{x, y, z}};
  return request;
}

}  // namespace

TEST_CASE("single values of nodes, elements and the whole", "[core][output]") {
  SampleRun run;
  run.deform(2.0 * Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero());
  run.state.time = 0.5;
  run.set_point_value(1, 1, 1, 4.0);
  Outcome found =
      ask(run, {at(request(L::nodal, "displacement", "x", "tip"), 1010), request(L::global, "time"),
                at(request(L::element, "stress", "yy"), 111), at(request(L::element, "centroid"), 102)});
  CHECK(found.messages.empty());
  CHECK(value_names(found.fields) ==
        Names{"tip", "time", "stress_yy", "centroid_x", "centroid_y", "centroid_z"});
  const std::vector<double> values = evaluate_all(found.fields, run.context());
  const double x = run.mesh.coordinates()(0, run.mesh.find_node(1010)->value);
  CHECK(values == std::vector<double>{x, 0.5, 4.0, 3.0, 1.0, 1.0});
  for (const OutputField& field : found.fields.fields()) CHECK(field.location == FieldLocation::global);
}

TEST_CASE("the entity nearest to a point is found on the undeformed mesh", "[core][output]") {
  SampleRun run;
  run.deform(100.0 * Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero());
  Outcome found = ask(run, {nearest(request(L::nodal, "model_coordinates"), 8.7, 0.1, -0.3),
                            nearest(request(L::element, "element_mass"), 0.4, 0.5, 1.2),
                            nearest(request(L::element, "eqps", "", "e"), 9, 0, 0)});
  CHECK(found.messages.empty());
  CHECK(evaluate_all(found.fields, run.context()) == std::vector<double>{9, 0, 0, 3, 0});
}

TEST_CASE("equal names are distinguished by the entities", "[core][output]") {
  const SampleRun run;
  const VariableRequest v = request(L::nodal, "velocity", "x");
  const Outcome found = ask(run, {at(v, 1001), at(v, 1002), at(v, 1002)});
  CHECK(value_names(found.fields) == Names{"velocity_x", "velocity_x_node_1002"});
  CHECK(found.messages == Names{"there is a value velocity_x_node_1002 already: this one is left out"});
}

TEST_CASE("places that do not exist are said", "[core][output]") {
  const SampleRun run;
  const Outcome found = ask(
      run, {at(request(L::nodal, "mass"), 7), at(request(L::element, "volume"), 7),
            at(request(L::element, "eqps"), 101), request(L::nodal, "mass"), request(L::global, "enthalpy")});
  CHECK(found.messages == Names{"error: the mesh has no node 7", "error: the mesh has no element 7",
                                "element 101 has no eqps", "mass is asked for without a place",
                                "no global variable 'enthalpy' is known here"});
  CHECK(value_names(found.fields).empty());
}

}  // namespace single_values_test

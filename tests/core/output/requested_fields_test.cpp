// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/requested_fields.hpp"

#include <memory>

#include "core/mesh/block_names.hpp"
#include "support/catch.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using L = VariableLocation;
using Names = std::vector<std::string>;

/// What a results file gets for some requests.
struct Outcome {
  std::shared_ptr<const OutputVariables> variables;
  RequestedFields fields;
  Names warnings;

  /// "<component name>@<block>" of all fields that are not global, without the block for nodal ones.
  Names names() const {
    Names names;
    for (const OutputField& field : fields.fields()) {
      const std::string at =
          field.location == FieldLocation::element ? "@" + std::to_string(field.block) : "";
      for (int c = 0; c < field.n_components && field.location != FieldLocation::global; ++c)
        names.push_back(component_name(field, c) + at);
    }
    return names;
  }
  Names globals() const {
    Names names;
    for (const OutputField& field : fields.fields()) {
      if (field.location == FieldLocation::global) names.push_back(field.name);
    }
    return names;
  }
};

Outcome ask(const SampleRun& run, const std::vector<VariableRequest>& requests, FieldRequests further = {}) {
  const auto variables = std::make_shared<const OutputVariables>(run.model);
  Diagnostics diagnostics;
  further.variables = requests;
  Outcome outcome{
      variables, make_requested_fields(*variables, further, find_block_names(run.mesh, {}), diagnostics), {}};
  for (const Diagnostic& found : diagnostics.all()) {
    CHECK(found.severity == Severity::warning);
    outcome.warnings.push_back(found.id + ": " + found.text);
  }
  return outcome;
}

VariableRequest on_parts(VariableRequest request, bool are_excluded, const std::string& part) {
  request.place = NamedParts{are_excluded, {{part, {}}}};
  return request;
}

}  // namespace

TEST_CASE("fields go to the file under the deck's names", "[core][output]") {
  const SampleRun run;
  const Outcome found =
      ask(run, {request(L::nodal, "displacement", "", "Displ"), request(L::nodal, "Mass"),
                request(L::nodal, "velocity", "x"), request(L::nodal, "velocity", "z", "vz"),
                request(L::element, "eqps"), request(L::element, "principal_stresses", "1")});
  CHECK(found.warnings.empty());
  CHECK(found.names() == Names{"Displ_x", "Displ_y", "Displ_z", "Mass", "velocity_x", "vz", "eqps@1",
                               "principal_stresses_1@0", "principal_stresses_1@1"});
}

TEST_CASE("energies and momentum are written unasked, once", "[core][output]") {
  const SampleRun run;
  CHECK(ask(run, {}).globals() == Names{"kinetic_energy", "internal_energy", "external_energy",
                                        "hourglass_energy", "bulk_viscosity_energy", "contact_energy",
                                        "energy_error", "momentum"});
  const Outcome asked = ask(run, {request(L::global, "Momentum"), request(L::global, "time")});
  CHECK(asked.warnings.empty());
  const Names globals = asked.globals();
  CHECK(globals.front() == "Momentum");
  CHECK(std::count(globals.begin(), globals.end(), "momentum") == 0);
}

TEST_CASE("element variables can be kept to some blocks", "[core][output]") {
  const SampleRun run;
  const VariableRequest vm = request(L::element, "von_mises");
  CHECK(ask(run, {on_parts(vm, false, "HARD")}).names() == Names{"von_mises@1"});
  CHECK(ask(run, {on_parts(vm, true, "block_20")}).names() == Names{"von_mises@0"});
  const std::vector<DeckName> hard{{"hard", {}}};
  FieldRequests included, excluded;
  included.included = hard;
  excluded.excluded = hard;
  CHECK(ask(run, {vm}, included).names() == Names{"von_mises@1"});
  CHECK(ask(run, {vm}, excluded).names() == Names{"von_mises@0"});
}

TEST_CASE("what cannot be written as asked is a warning", "[core][output]") {
  const SampleRun run;
  const VariableRequest vm = request(L::element, "von_mises"), v = request(L::nodal, "velocity");
  CHECK(ask(run, {on_parts(vm, false, "hadr")}).warnings ==
        Names{"output-part-unknown: 'hadr' is no block of the mesh",
              "output-part-none: no block that is asked for has von_mises"});
  CHECK(ask(run, {on_parts(v, false, "hard")}).warnings ==
        Names{"output-part-whole: velocity is written for the whole model: parts are for element variables"});
  const Outcome twice = ask(run, {v, request(L::nodal, "displacement", "", "Velocity")});
  CHECK(twice.warnings ==
        Names{"output-name-taken: a nodal variable Velocity is on the file already: this one is left out"});
  CHECK(twice.names().size() == 3);
  CHECK(ask(run, {on_parts(vm, false, "hard"), on_parts(vm, true, "hard")}).warnings.empty());
}

TEST_CASE("the separator of components can be chosen", "[core][output]") {
  const SampleRun run;
  FieldRequests requests;
  requests.separator = "";
  CHECK(ask(run, {request(L::nodal, "velocity"), request(L::element, "stress", "xy")}, requests).names() ==
        Names{"velocityx", "velocityy", "velocityz", "stressxy@0", "stressxy@1"});
}

TEST_CASE("fields have the values of the moment", "[core][output]") {
  SampleRun run;
  Outcome found = ask(run, {request(L::nodal, "displacement", "x"), request(L::element, "volume")});
  run.deform(3.0 * Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero());
  const Eigen::Matrix3Xd before = run.state.coordinates;
  const std::span<const double> x = found.fields.evaluate(0, run.context());
  REQUIRE(x.size() == run.mesh.n_nodes());
  for (std::size_t n = 0; n < x.size(); ++n)
    CHECK(x[n] == Approx(2.0 * run.mesh.coordinates()(0, static_cast<Eigen::Index>(n))));
  CHECK(found.fields.evaluate(1, run.context()).size() == 9);
  CHECK(found.fields.evaluate(2, run.context())[1] == Approx(27.0));
  CHECK(run.state.coordinates == before);
}

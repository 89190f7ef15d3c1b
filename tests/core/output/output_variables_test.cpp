// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/output_variables.hpp"

#include <algorithm>

#include "support/catch.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("a run has the variables of the tables, of shells only with shells", "[core][output]") {
  const SampleRun run;
  const OutputVariables variables(run.model);
  CHECK(variables.find(FieldLocation::global, "momentum") != nullptr);
  CHECK(variables.find(FieldLocation::node, "velocity") != nullptr);
  CHECK(variables.find(FieldLocation::element, "stress")->in_blocks == std::vector<std::uint8_t>{1, 1});
  CHECK(variables.find(FieldLocation::element, "element_thickness") == nullptr);
  CHECK(variables.find(FieldLocation::element, "velocity") == nullptr);
  const auto names = variables.names(FieldLocation::node);
  CHECK(std::count(names.begin(), names.end(), "velocity") == 1);
  CHECK(std::count(names.begin(), names.end(), "stress") == 0);
}

TEST_CASE("what several materials remember under one name is one variable", "[core][output]") {
  SampleRun run;
  const OutputVariables one(run.model);
  CHECK(one.find(FieldLocation::element, "eqps")->in_blocks == std::vector<std::uint8_t>{0, 1});
  run.model.blocks[0].properties.law = run.model.blocks[1].properties.law;
  const OutputVariables both(run.model);
  const OutputVariable* eqps = both.find(FieldLocation::element, "eqps");
  CHECK(eqps->in_blocks == std::vector<std::uint8_t>{1, 1});
  CHECK(eqps->is_at_points);
  const auto names = both.names(FieldLocation::element);
  CHECK(std::count(names.begin(), names.end(), "eqps") == 1);
}

TEST_CASE("what is added is known by its name and location, the last first", "[core][output]") {
  const SampleRun run;
  OutputVariable given;
  given.name = "contact_area";
  OutputVariables variables(run.model, {given});
  CHECK(variables.find(FieldLocation::global, "contact_area") != nullptr);
  given.n_components = 2;
  const OutputVariable& second = variables.add(given);
  CHECK(variables.find(FieldLocation::global, "contact_area") == &second);
}

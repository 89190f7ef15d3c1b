// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/output_groups.hpp"

#include <array>

#include "core/output/requested_fields.hpp"
#include "core/output/single_values.hpp"
#include "support/catch.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using L = VariableLocation;

constexpr std::array<std::string_view, 2> of_motion{"velocity", "displacement"};
constexpr std::array groups{OutputGroup{"motion", FieldLocation::node, of_motion, "How nodes move"}};
constexpr std::array foreign{ForeignVariable{"u", "displacement"}};

/// The names that requests expand to, and what is reported.
std::string expanded(const VariableRequest& asked) {
  const SampleRun run;
  const OutputVariables variables(run.model, {}, {groups, foreign});
  Diagnostics diagnostics;
  std::string text;
  for (const VariableRequest& one : expand_groups(variables, std::span(&asked, 1), diagnostics))
    text += output_name(one) + one.variable.component + " ";
  for (const Diagnostic& reported : diagnostics.all()) text += reported.id;
  return text;
}

}  // namespace

TEST_CASE("a group stands for its members, at its location or where none is said", "[core][output]") {
  CHECK(expanded(request(L::nodal, "Motion")) == "velocity displacement ");
  CHECK(expanded(request(L::any, "motion")) == "velocity displacement ");
  CHECK(expanded(request(L::element, "motion")) == "motion ");
  CHECK(expanded(request(L::nodal, "velocity")) == "velocity ");
}

TEST_CASE("a group has no components and no other name", "[core][output]") {
  CHECK(expanded(request(L::nodal, "motion", "x")) == "velocity displacement output-group");
  VariableRequest renamed = request(L::nodal, "motion");
  renamed.alias = "m";
  CHECK(expanded(renamed) == "velocity displacement output-group");
}

TEST_CASE("results files hold the members of a group, values need a place", "[core][output]") {
  const SampleRun run;
  const OutputVariables variables(run.model, {}, {groups, foreign});
  const std::vector<VariableRequest> asked{request(L::nodal, "motion")};
  Diagnostics diagnostics;
  const RequestedFields fields = make_requested_fields(variables, {asked, {}, {}}, {}, diagnostics);
  REQUIRE(fields.size() >= 2);
  CHECK(fields.fields()[0].name == "velocity");
  CHECK(fields.fields()[1].name == "displacement");
  CHECK(diagnostics.empty());
  CHECK(make_single_values(variables, asked, "_", diagnostics).size() == 0);
  CHECK(diagnostics.all().size() == 2);
}

TEST_CASE("another program's name gets ours as a hint", "[core][output]") {
  const SampleRun run;
  const OutputVariables variables(run.model, {}, {groups, foreign});
  Diagnostics diagnostics;
  const VariableRequest asked = request(L::nodal, "U"), misspelt = request(L::nodal, "moton"),
                        elsewhere = request(L::element, "Motion");
  CHECK(!find_selection(variables, asked.location, asked.variable, diagnostics));
  CHECK(!find_selection(variables, misspelt.location, misspelt.variable, diagnostics));
  CHECK(!find_selection(variables, elsewhere.location, elsewhere.variable, diagnostics));
  REQUIRE(diagnostics.all().size() == 3);
  CHECK(diagnostics.all()[2].hint == "did you mean nodal Motion?");
  CHECK(diagnostics.all()[0].hint == "here it is called displacement");
  CHECK(diagnostics.all()[1].hint == "did you mean 'motion'?");
}

// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/termination.hpp"

#include <limits>

#include "support/catch.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using L = VariableLocation;

TerminationCriterion criterion(L location, const std::string& name, Comparison comparison, double value) {
  TerminationCriterion made;
  made.location = location;
  made.test.variable.name = {name, {}};
  made.test.comparison = comparison;
  made.test.value = value;
  return made;
}

/// Why a run ends, "" when it does not.
std::string reason(const SampleRun& run, const SolutionTermination& definition) {
  const OutputVariables variables(run.model);
  Diagnostics diagnostics;
  const Terminations terminations({&definition, 1}, variables, diagnostics);
  CHECK(diagnostics.empty());
  return terminations.find_end(run.context()).value_or(EarlyEnd{}).reason;
}

std::string reason(const SampleRun& run, const TerminationCriterion& one) {
  SolutionTermination definition;
  definition.criteria = {one};
  return reason(run, definition);
}

}  // namespace

TEST_CASE("a global variable ends the run", "[core][output]") {
  SampleRun run;
  const TerminationCriterion fast = criterion(L::global, "kinetic_energy", Comparison::greater, 5.0);
  run.state.energies.kinetic = 5.0;
  CHECK(reason(run, fast).empty());
  run.state.energies.kinetic = 5.5;
  CHECK(reason(run, fast) == "kinetic_energy is 5.5 > 5");
  CHECK(reason(run, criterion(L::global, "kineticenergy", Comparison::equal, 5.5)) ==
        "kineticenergy is 5.5 = 5.5");
}

TEST_CASE("globals that all ranks know need no whole state", "[core][output]") {
  const SampleRun run;
  const OutputVariables variables(run.model);
  const auto reads_all = [&](L location, const std::string& name) {
    SolutionTermination definition;
    definition.criteria = {criterion(location, name, Comparison::greater, 5.0)};
    Diagnostics diagnostics;
    return Terminations({&definition, 1}, variables, diagnostics).reads_all();
  };
  CHECK_FALSE(reads_all(L::global, "kinetic_energy"));
  CHECK(reads_all(L::global, "strain_energy"));
  CHECK_FALSE(reads_all(L::nodal, "mass"));  // each rank has values of its own
  Diagnostics diagnostics;
  CHECK_FALSE(Terminations({}, variables, diagnostics).reads_all());
}

TEST_CASE("any node or element may end the run, or their mean, or an extreme", "[core][output]") {
  SampleRun run;
  run.set_point_value(0, 8, 0, 22.0);
  const TerminationCriterion any = criterion(L::element, "von_mises", Comparison::greater_equal, 22.0);
  CHECK(reason(run, any) == "von_mises is 22 >= 22");
  TerminationCriterion mean = any;
  mean.reduction = NodalCriterion::Reduction::average;
  CHECK(reason(run, mean).empty());
  mean.test.value = 2.0;
  CHECK(reason(run, mean) == "von_mises is 2 >= 2");
  TerminationCriterion least = any;
  least.reduction = NodalCriterion::Reduction::minimum;
  least.test.comparison = Comparison::less;
  CHECK(reason(run, least) == "von_mises is 0 < 22");
  run.state.velocity(1, 3) = -7.0;
  CHECK(reason(run, criterion(L::nodal, "velocity", Comparison::less, -6.0)) == "velocity is -7 < -6");
}

TEST_CASE("criteria rest in the times that are skipped", "[core][output]") {
  SampleRun run;
  SolutionTermination definition;
  definition.criteria = {criterion(L::global, "time", Comparison::greater, 0.0)};
  definition.skipped_times = {{1.0, 2.0}, {4.0, 5.0}};
  const auto ends_at = [&](double time) {
    run.state.time = time;
    return !reason(run, definition).empty();
  };
  CHECK(ends_at(0.5));
  CHECK_FALSE(ends_at(1.0));
  CHECK_FALSE(ends_at(2.0));
  CHECK(ends_at(3.0));
  CHECK_FALSE(ends_at(4.5));
}

TEST_CASE("what is not a number ends no run", "[core][output]") {
  SampleRun run;
  run.state.energies.kinetic = std::numeric_limits<double>::quiet_NaN();
  CHECK(reason(run, criterion(L::global, "kinetic_energy", Comparison::less, 1.0)).empty());
}

TEST_CASE("a criterion of an unknown variable is an error", "[core][output]") {
  const SampleRun run;
  const OutputVariables variables(run.model);
  SolutionTermination definition;
  definition.criteria = {criterion(L::global, "kinetic_enrgy", Comparison::greater, 5.0)};
  Diagnostics diagnostics;
  const Terminations terminations({&definition, 1}, variables, diagnostics);
  REQUIRE(diagnostics.error_count() == 1);
  CHECK(diagnostics.all()[0].text == "no global variable 'kinetic_enrgy' is known here");
}

// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/output_schedule_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

OutputSchedule schedule_of(const std::string& lines) {
  const BoundRegion bound = bound_region("begin results output\n" + lines + "end\n");
  CHECK(bound.messages == "");
  return bound.region.results_outputs.at(0).schedule;
}

}  // namespace

TEST_CASE("times repeat in phases, with either word for the increment", "[parser][output]") {
  const OutputSchedule schedule =
      schedule_of("at time 0, increment = 1\nat time 0.5 interval 0.25\nat time=1.0e-3 increment 2\n");
  REQUIRE(schedule.time_phases.size() == 3);
  CHECK(schedule.time_phases[0].start == 0.0);
  CHECK(schedule.time_phases[0].increment == 1.0);
  CHECK(schedule.time_phases[1].start == 0.5);
  CHECK(schedule.time_phases[1].increment == 0.25);
  CHECK(schedule.time_phases[2].start == 1.0e-3);
}

TEST_CASE("steps repeat in phases", "[parser][output]") {
  const OutputSchedule schedule = schedule_of("at step 0 increment = 10\nat step 100 interval = 1\n");
  REQUIRE(schedule.step_phases.size() == 2);
  CHECK(schedule.step_phases[0].increment == 10);
  CHECK(schedule.step_phases[1].start == 100);
}

TEST_CASE("a schedule takes all of its lines", "[parser][output]") {
  const OutputSchedule schedule = schedule_of(
      "additional times = 0.1 0.2\nadditional times = 0.3\nadditional steps = 5 6\nstart time = 0.01\n"
      "termination time = 0.5\ntimestep adjustment interval = 4\nuse output scheduler often\n");
  CHECK(schedule.additional_times == std::vector<double>{0.1, 0.2, 0.3});
  CHECK(schedule.additional_steps == std::vector<std::int64_t>{5, 6});
  CHECK(schedule.start_time == 0.01);
  CHECK(schedule.termination_time == 0.5);
  CHECK(schedule.adjustment_interval == 4);
  CHECK(schedule.scheduler->text == "often");
}

TEST_CASE("a phase needs a positive increment", "[parser][output]") {
  CHECK(bound_region(
            "begin results output\nat time 0 increment = 0\nat time 0\nat step -1 increment = 1\nend\n")
            .messages ==
        "a.i:2:23: error: 'at time' must be greater than 0, found '0'\n"
        "a.i:3:1: error: expected 'increment' in 'at time', found the end of the line\n"
        "a.i:4:9: error: 'at step' must not be negative, found '-1'\n");
}

TEST_CASE("lines on signals and files are ignored", "[parser][output]") {
  const std::string line =
      GENERATE("synchronize output", "output on signal = SIGUSR1", "auto output 10", "exists = append");
  const std::string found = bound_region("begin results output\n" + line + "\nend\n").messages;
  CHECK(found.find("a.i:2:1: warning: ") == 0);
  CHECK(found.find("[deck-ignored]") != std::string::npos);
}

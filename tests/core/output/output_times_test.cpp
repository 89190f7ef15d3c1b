// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/output_times.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// The steps that are written of a run with equal steps.
std::vector<int> due_steps(const OutputSchedule& schedule, double dt, int n_steps,
                           std::int64_t default_increment = 1) {
  OutputTimes times(schedule, default_increment);
  std::vector<int> due;
  double time = 0.0;
  for (int step = 0; step <= n_steps; ++step) {
    if (times.is_due({step, time, step == n_steps})) due.push_back(step);
    time += dt;
  }
  return due;
}

OutputSchedule at_time(double start, double increment) {
  OutputSchedule schedule;
  schedule.time_phases = {{start, increment}};
  return schedule;
}

using Steps = std::vector<int>;

}  // namespace

TEST_CASE("the step that reaches or passes a scheduled time is written, and the last", "[core][output]") {
  // Times 0, 0.3, 0.6, ...; scheduled 0, 1, 2.
  CHECK(due_steps(at_time(0.0, 1.0), 0.3, 8) == Steps{0, 4, 7, 8});
  CHECK(due_steps(at_time(0.5, 1.0), 0.3, 8) == Steps{2, 5, 8});
}

TEST_CASE("a time that rounding keeps from its number counts as reached", "[core][output]") {
  // The sum of ten steps of 0.1 is below 1.
  CHECK(due_steps(at_time(0.0, 1.0), 0.1, 30) == Steps{0, 10, 20, 30});
  CHECK(due_steps(at_time(0.0, 1e-6), 1e-7, 30) == Steps{0, 10, 20, 30});
}

TEST_CASE("several scheduled times in one step are one output", "[core][output]") {
  CHECK(due_steps(at_time(0.0, 0.01), 1.0, 3) == Steps{0, 1, 2, 3});
}

TEST_CASE("a later phase takes over at its start, in any order of the lines", "[core][output]") {
  OutputSchedule schedule;
  schedule.time_phases = {{4.0, 2.0}, {0.0, 1.0}};
  CHECK(due_steps(schedule, 1.0, 9) == Steps{0, 1, 2, 3, 4, 6, 8, 9});
  OutputSchedule steps;
  steps.step_phases = {{0, 3}, {7, 1}};
  CHECK(due_steps(steps, 1.0, 10) == Steps{0, 3, 6, 7, 8, 9, 10});
}

TEST_CASE("times, steps and additional ones add up", "[core][output]") {
  OutputSchedule schedule = at_time(0.0, 5.0);
  schedule.step_phases = {{2, 6}};
  schedule.additional_times = {3.5};
  schedule.additional_steps = {7};
  CHECK(due_steps(schedule, 1.0, 12) == Steps{0, 2, 4, 5, 7, 8, 10, 12});
}

TEST_CASE("nothing is written outside start and termination time", "[core][output]") {
  OutputSchedule schedule = at_time(0.0, 1.0);
  schedule.start_time = 2.0;
  schedule.termination_time = 4.0;
  CHECK(due_steps(schedule, 1.0, 6) == Steps{2, 3, 4});
}

TEST_CASE("without a schedule the default holds", "[core][output]") {
  CHECK(due_steps({}, 1.0, 3) == Steps{0, 1, 2, 3});
  CHECK(due_steps({}, 1.0, 5, 2) == Steps{0, 2, 4, 5});
  CHECK(due_steps({}, 1.0, 5, 0) == Steps{0, 5});
}

TEST_CASE("the next scheduled time can be asked for", "[core][output]") {
  OutputSchedule schedule;
  schedule.time_phases = {{1.0, 2.0}, {6.0, 10.0}};
  schedule.additional_times = {3.5};
  schedule.termination_time = 20.0;
  const OutputTimes times(schedule, 1);
  CHECK(times.next_time(0.0) == 1.0);
  CHECK(times.next_time(1.0) == 3.0);
  CHECK(times.next_time(3.0) == 3.5);
  CHECK(times.next_time(3.5) == 5.0);
  CHECK(times.next_time(5.0) == 6.0);
  CHECK(times.next_time(6.0) == 16.0);
  CHECK_FALSE(times.next_time(16.0));
}

TEST_CASE("an output scheduler adds to the schedule that uses it", "[core][output]") {
  OutputSchedule schedule = at_time(0.0, 5.0);
  schedule.scheduler = DeckName{"Fine", {}};
  const std::vector<OutputScheduler> schedulers{{{"other", {}}, at_time(0.0, 1.0)},
                                                {{"fine", {}}, at_time(3.0, 3.0)}};
  Diagnostics diagnostics;
  const OutputSchedule resolved = resolve_schedule(schedule, schedulers, diagnostics);
  CHECK(diagnostics.empty());
  CHECK(due_steps(resolved, 1.0, 7) == Steps{0, 3, 6, 7});

  schedule.scheduler = DeckName{"fin", {}};
  resolve_schedule(schedule, schedulers, diagnostics);
  REQUIRE(diagnostics.error_count() == 1);
  CHECK(diagnostics.all()[0].text == "the output scheduler 'fin' is not defined");
  CHECK(diagnostics.all()[0].hint == "did you mean 'fine'?");
}

TEST_CASE("an output with a huge number of scheduled times is as quick as any", "[core][output]") {
  CHECK(due_steps(at_time(-1e300, 1e-300), 1.0, 2) == Steps{0, 2});
}

TEST_CASE("a step is written once, even when it turns out to be the last", "[core][output]") {
  OutputTimes times(at_time(0.0, 1.0), 1);
  CHECK(times.is_due({0, 0.0, false}));
  CHECK_FALSE(times.is_due({0, 0.0, true}));
  CHECK_FALSE(times.is_due({1, 0.5, false}));
  CHECK(times.is_due({1, 0.5, true}));
}

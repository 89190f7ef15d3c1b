// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/load_schedule.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Steps from the start to the end of the schedule.
std::vector<double> times(LoadSchedule& schedule, double time) {
  std::vector<double> ends;
  while (!schedule.is_over(time) && ends.size() < 1000) {
    time = schedule.end_of(time, schedule.step_at(time));
    ends.push_back(time);
    schedule.note_success(time, 1);
  }
  return ends;
}

}  // namespace

TEST_CASE("load steps end where periods do", "[core][statics]") {
  LoadSchedule schedule({{{}, 0.0, 1.0, 0.3, {}}, {{}, 1.0, 2.0, 0.5, {}}}, std::nullopt);
  const std::vector<double> ends = times(schedule, 0.0);
  REQUIRE(ends.size() == 6);
  CHECK(ends[2] == Approx(0.9));
  CHECK(ends[3] == 1.0);
  CHECK(ends[4] == 1.5);
  CHECK(ends[5] == 2.0);
  CHECK(schedule.begins_period(1.0));
  CHECK_FALSE(schedule.begins_period(1.5));
}

TEST_CASE("round-off makes no step of its own", "[core][statics]") {
  LoadSchedule schedule({{{}, 0.0, 1.0, 0.1, {}}}, std::nullopt);
  const std::vector<double> ends = times(schedule, 0.0);
  CHECK(ends.size() == 10);
  CHECK(ends.back() == 1.0);
}

TEST_CASE("steps are cut back where no equilibrium is found, and grow again", "[core][statics]") {
  LoadSchedule schedule({{{}, 0.0, 10.0, 1.0, {}}}, std::nullopt);
  CHECK(schedule.cut_back(0.0));
  CHECK(schedule.cut_back(0.0));
  CHECK(schedule.step_at(0.0) == 0.25);
  schedule.note_success(0.0, 5);
  CHECK(schedule.step_at(0.0) == Approx(0.375));
  for (int i = 0; i < 20; ++i) schedule.note_success(0.0, 5);
  CHECK(schedule.step_at(0.0) == 1.0);
  int n_cutbacks = 0;
  while (schedule.cut_back(0.0)) ++n_cutbacks;
  CHECK(n_cutbacks == 10);
}

TEST_CASE("steps that have been cut back end where those of the deck would", "[core][statics]") {
  LoadSchedule schedule({{{}, 0.0, 1.0, 0.5, {}}}, std::nullopt);
  schedule.cut_back(0.0);
  const std::vector<double> ends = times(schedule, 0.0);
  CHECK(ends == std::vector<double>{0.25, 0.5, 1.0});
}

TEST_CASE("steps follow the number of iterations", "[core][statics]") {
  AdaptiveTimeStepping adaption;
  adaption.target_iterations = 50;
  adaption.iteration_window = 10;
  adaption.growth_factor = 2.0;
  adaption.max_multiplier = 4.0;
  adaption.min_multiplier = 0.5;
  LoadSchedule schedule({{{}, 0.0, 10.0, 1.0, {}}}, adaption);
  schedule.note_success(0.0, 45);
  CHECK(schedule.multiplier() == 1.0);  // within the window
  schedule.note_success(0.0, 39);
  CHECK(schedule.multiplier() == 2.0);
  for (int i = 0; i < 3; ++i) schedule.note_success(0.0, 1);
  CHECK(schedule.multiplier() == 4.0);
  for (int i = 0; i < 9; ++i) schedule.note_success(0.0, 61);
  CHECK(schedule.multiplier() == 0.5);
  CHECK_FALSE(schedule.cut_back(0.0));  // it may get no smaller
}

TEST_CASE("time stepping blocks have multipliers of their own", "[core][statics]") {
  AdaptiveTimeStepping adaption;
  adaption.growth_factor = 2.0;
  adaption.max_multiplier = 8.0;
  adaption.during.push_back({{"slow", {}}, [](AdaptiveTimeStepping& slow) { slow.max_multiplier = 2.0; }});
  LoadSchedule schedule({{{"slow", {}}, 0.0, 1.0, 0.1, {}}, {{"fast", {}}, 1.0, 2.0, 0.1, {}}}, adaption);
  for (int i = 0; i < 5; ++i) schedule.note_success(0.5, 1);
  CHECK(schedule.multiplier() == 2.0);
  for (int i = 0; i < 5; ++i) schedule.note_success(1.5, 1);
  CHECK(schedule.multiplier() == 8.0);
}

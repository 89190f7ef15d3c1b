// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/time_step.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

TimePeriod period(const std::string& name, double start) {
  TimePeriod made{name, start, {}};
  made.parameters.time_step_scale_factor = 0.5;
  return made;
}

}  // namespace

TEST_CASE("a period lasts from its start to the start of the next", "[core][time_step]") {
  const TimeStepControl control({period("a", 0.0), period("b", 1.0), period("c", 2.0)}, 3.0);
  CHECK(control.period_at(-1.0) == 0);
  CHECK(control.period_at(0.999) == 0);
  CHECK(control.period_at(1.0) == 1);
  CHECK(control.period_at(5.0) == 2);
}

TEST_CASE("the step is the scaled stable one and grows by the increase factor at most", "[core][time_step]") {
  const TimeStepControl control({period("a", 0.0)}, 1.0);
  CHECK(control.step_after(0.0, 0.0, 0.1) == 0.05);
  CHECK(control.step_after(0.5, 0.01, 0.1) == Approx(0.011));
  CHECK(control.step_after(0.5, 0.049, 0.1) == 0.05);
  CHECK(control.step_after(0.5, 0.049, 0.01) == 0.005);
}

TEST_CASE("the initial step bounds the first step of its period alone", "[core][time_step]") {
  TimePeriod second = period("b", 1.0);
  second.parameters.initial_time_step = 1e-3;
  const TimeStepControl control({period("a", 0.0), second}, 2.0);
  CHECK(control.step_after(0.0, 0.0, 0.1) == 0.05);
  CHECK(control.step_after(1.01, 0.05, 0.1) == 1e-3);
  CHECK(control.step_after(1.5, 0.001, 0.1) == Approx(1.1e-3));
}

TEST_CASE("a user time step replaces the estimate", "[core][time_step]") {
  TimePeriod only = period("a", 0.0);
  only.parameters.user_time_step = 0.25;
  const TimeStepControl control({only}, 1.0);
  CHECK(control.step_after(0.0, 0.0, 0.1) == 0.25);
  CHECK(control.step_after(0.5, 0.01, 0.1) == 0.25);
}

TEST_CASE("a run ends at the first step at or past the termination time, round-off allowed for",
          "[core][time_step]") {
  const TimeStepControl control({period("a", 0.0)}, 1.0);
  double time = 0.0;
  int steps = 0;
  for (; !control.is_over(time, 0.1); ++steps) time += 0.1;
  CHECK(steps == 10);
  CHECK(control.is_over(1.05, 0.1));
  CHECK_FALSE(control.is_over(0.99, 0.1));
}

TEST_CASE("steps before a target are shortened evenly to end at its time", "[core][time_step]") {
  TimeStepControl control({period("a", 0.0)}, 1.0);
  control.add_target({[](double time) { return time < 0.32 ? std::optional(0.32) : std::nullopt; }, 3});
  double time = 0.0, before = 0.0;
  std::vector<double> steps;
  while (time < 0.4) {
    before = control.step_after(time, before, 0.2);  // free steps of 0.1
    time += before;
    steps.push_back(before);
  }
  REQUIRE(steps.size() == 5);
  CHECK(steps[0] == Approx(0.1));  // four steps away: not yet
  for (int i : {1, 2, 3}) CHECK(steps[i] == Approx(0.22 / 3));
  CHECK(steps[4] == Approx(0.22 / 3 * 1.1));  // and grows again
}

TEST_CASE("the least stable step is held through vibrations and forgotten after", "[core][time_step]") {
  HeldStableStep vibrating;
  for (int step = 0; step < 1000; ++step) {
    const double held = vibrating.take(2.0 + std::cos(0.1 * step + 3.0));  // a period of 63 steps
    if (step > 63) CHECK(held == Approx(1.0).margin(2e-3));
  }
  HeldStableStep passed;
  CHECK(passed.take(0.5) == 0.5);
  for (int step = 1; step < 200; ++step) CHECK(passed.take(1.0) == 0.5);
  CHECK(passed.take(0.4) == 0.4);  // at once
}

TEST_CASE("the stable step comes back by half a percent per step", "[core][time_step]") {
  HeldStableStep step;
  step.take(0.5);
  for (int i = 1; i < 200; ++i) step.take(1.0);
  double held = 0.5;
  while (1.005 * held < 1.0) {
    const double next = step.take(1.0);
    REQUIRE(next == Approx(1.005 * held));
    held = next;
  }
  CHECK(step.take(1.0) == 1.0);
  CHECK(step.take(0.9) == 0.9);
}

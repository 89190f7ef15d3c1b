// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/output_schedule_commands.hpp"

namespace contactsim {

namespace {

/// "INCREMENT =", or INTERVAL, its older word; the = may be missing.
void expect_increment(Arguments& arguments) {
  if (!arguments.accept("interval")) arguments.expect("increment");
  arguments.skip_separator();
}

void read_time_phase(Arguments& arguments, OutputSchedule& schedule) {
  TimePhase phase{arguments.real(), 0.0};
  expect_increment(arguments);
  phase.increment = arguments.positive();
  schedule.time_phases.push_back(phase);
}

void read_step_phase(Arguments& arguments, OutputSchedule& schedule) {
  StepPhase phase{arguments.non_negative_integer(), 1};
  expect_increment(arguments);
  phase.increment = arguments.positive_integer();
  schedule.step_phases.push_back(phase);
}

}  // namespace

std::vector<Row<OutputSchedule>> output_schedule_rows() {
  using S = OutputSchedule;
  return {
      row<S>("at time", "<t0> {INCREMENT|INTERVAL} = <dt>", read_time_phase,
             "Writes from t0 on every dt [time], until a later such line takes over", "none"),
      row<S>("at step", "<n0> {INCREMENT|INTERVAL} = <n>", read_step_phase,
             "Writes from step n0 on every n steps [1], until a later such line takes over", "none"),
      row("additional times", read::reals, &S::additional_times, "Further times to write at [time]"),
      row("additional steps", read::integers, &S::additional_steps, "Further steps to write at [1]"),
      row("start time", read::real, &S::start_time, "Nothing is written before this time [time]"),
      row("termination time", read::real, &S::termination_time, "Nothing is written after this time [time]"),
      row("timestep adjustment interval", read::positive_integer, &S::adjustment_interval,
          "Steps [1] before an output time that are stretched to hit it"),
      row("use output scheduler", read::name_of(NameKind::output_scheduler), &S::scheduler,
          "A schedule defined by BEGIN OUTPUT SCHEDULER"),
      ignored<S>("synchronize output", "", "There is one region only, nothing to synchronise with"),
      ignored<S>("output on signal", "= <signal>", "Signals are not listened to"),
      ignored<S>("exists", "= <words>", "Existing files are overwritten or not by OVERWRITE alone"),
      ignored<S>("auto output", "<words>", "Output is written by the schedule alone"),
  };
}

}  // namespace contactsim

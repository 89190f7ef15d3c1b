// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/time_commands.hpp"

#include <fmt/format.h>

#include "parser/commands/block_rows.hpp"

namespace contactsim {

namespace {

const Table<ExplicitTimeParameters>& explicit_parameters_table() {
  using P = ExplicitTimeParameters;
  static const Table<P> table({
      row("initial time step", read::positive, &P::initial_time_step, "First time step [time]",
          "critical step"),
      row("time step scale factor", read::positive, &P::time_step_scale_factor,
          "Share of the critical step that is taken [1]"),
      row("time step increase factor", read::positive, &P::time_step_increase_factor,
          "Largest growth from one step to the next [1]"),
      row("step interval", read::positive_integer, &P::step_interval,
          "Steps between two lines of the log [1]"),
      row("user time step", read::positive, &P::user_time_step, "Step in place of the critical one [time]"),
      ignored<P>("time step selector", "= AUTO", "the smallest step of all elements is taken"),
      ignored<P>("print banner interval for solution control", "= <integer>", "STEP INTERVAL sets the log"),
  });
  return table;
}

const Table<ImplicitTimeParameters>& implicit_parameters_table() {
  using P = ImplicitTimeParameters;
  static const Table<P> table({
      row("time increment", read::positive, &P::time_increment, "Implicit only: time step [time]"),
      row("number of time steps", read::positive_integer, &P::n_time_steps,
          "Implicit only: steps in the block [1]"),
      row("time increment function", read::name_of(NameKind::function), &P::increment_function,
          "Implicit only: function of time whose value is the step"),
  });
  return table;
}

const Table<TimeSteppingBlock>& time_stepping_block_table() {
  using B = TimeSteppingBlock;
  static const Table<B> table({
      row("start time", read::real, &B::start_time, "When the block begins [time]").required(),
      block("parameters for presto region", Naming::required, explicit_parameters_table,
            &B::explicit_parameters, "Time step of a region")
          .references(NameKind::region),
      block("parameters for adagio region", Naming::required, implicit_parameters_table,
            &B::implicit_parameters, "Time step of a region; makes the procedure implicit")
          .references(NameKind::region),
  });
  return table;
}

void add_at(DeckNames& names, const DeckName& block, std::string text, std::string hint = "") {
  names.problems_of_block().add_error(block.location,
                                      fmt::format("the time stepping block '{}' {}", block.text, text),
                                      std::move(hint), static_cast<int>(block.text.size()));
}

/// A step that is given must end within its block.
///   end  of the block [time]
void check_user_step(const TimeSteppingBlock& block, double end, DeckNames& names) {
  constexpr double round_off = 1e-9;  // of a step
  const double duration = end - block.start_time;
  for (const ExplicitTimeParameters& parameters : block.explicit_parameters) {
    if (!parameters.user_time_step || !(duration > 0.0)) continue;
    const double step = *parameters.user_time_step;
    if (step <= duration * (1.0 + round_off)) continue;
    add_at(names, block.name,
           fmt::format("lasts {:.6g}, less than its USER TIME STEP of {:.6g}", duration, step));
  }
}

/// Blocks must follow each other in time; one without a start time is told of elsewhere.
void check(const TimeControl& control, DeckNames& names) {
  const TimeSteppingBlock* last = nullptr;
  for (const TimeSteppingBlock& block : control.time_stepping_blocks) {
    if (std::isnan(block.start_time)) continue;
    if (last != nullptr && block.start_time <= last->start_time) {
      add_at(names, block.name,
             fmt::format("starts at {}, not after '{}', which starts at {}", block.start_time,
                         last->name.text, last->start_time),
             "blocks follow each other in time");
    }
    if (last != nullptr) check_user_step(*last, block.start_time, names);
    last = &block;
  }
  if (last != nullptr) check_user_step(*last, control.termination_time, names);
  for (const TimeSteppingBlock& block : control.time_stepping_blocks) {
    if (!(control.termination_time <= block.start_time)) continue;
    const std::string text = fmt::format("starts at {}, not before the termination time {}", block.start_time,
                                         control.termination_time);
    if (&block == &control.time_stepping_blocks.front()) {
      add_at(names, block.name, text);
    } else {
      names.problems_of_block().add_warning(
          "time-block-unused", block.name.location,
          fmt::format("the time stepping block '{}' {}: it is never run", block.name.text, text), "",
          static_cast<int>(block.name.text.size()));
    }
  }
}

}  // namespace

const Table<TimeControl>& time_control_table() {
  using C = TimeControl;
  static const Table<C> table(
      {
          block("time stepping block", Naming::required, time_stepping_block_table, &C::time_stepping_blocks,
                "A period: from its start time to that of the next such block")
              .defines(NameKind::time_stepping_block)
              .required(),
          row("termination time", read::real, &C::termination_time, "When the procedure ends [time]")
              .required(),
      },
      check);
  return table;
}

}  // namespace contactsim

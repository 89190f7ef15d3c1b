// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/output_restart_commands.hpp"

#include <fmt/format.h>

#include "parser/commands/output_schedule_commands.hpp"
#include "parser/commands/row_lists.hpp"
#include "parser/text/word_grammar.hpp"

namespace contactsim {

namespace {

/// A time of the clock in seconds.
double read_wall_time(Arguments& arguments) {
  const Word& word = arguments.word("a time such as 12h");
  const auto seconds = find_wall_time(word.text);
  if (!seconds || *seconds < 0.0) {
    arguments.fail(word, fmt::format("expected a time such as 30s, 700m, 12h or 1d for '{}', found '{}'",
                                     arguments.what(), word.text));
  }
  return *seconds;
}

void read_wall_time_phase(Arguments& arguments, RestartData& restart) {
  WallTimePhase phase{read_wall_time(arguments), 0.0};
  if (!arguments.accept("interval")) arguments.expect("increment");
  arguments.skip_separator();
  phase.increment = read_wall_time(arguments);
  if (phase.increment <= 0.0) arguments.fail_here("the increment of 'at wall time' must be greater than 0");
  restart.wall_time_phases.push_back(phase);
}

void read_automatic_restart(Arguments& arguments, RestartData& restart) {
  static const Choices choices({"automatic", "auto"});
  arguments.choice(choices);
  restart.is_automatic = true;
}

}  // namespace

const Table<RestartData>& restart_table() {
  using R = RestartData;
  static const Table<R> table(joined<R>({
      {
          row("database name", read::name, &R::database,
              "File to read and write; %B stands for the deck's base name",
              "the deck's base name and .rsout"),
          row("input database name", read::name, &R::input_database,
              "File to read, in place of DATABASE NAME"),
          row("output database name", read::name, &R::output_database,
              "File to write, in place of DATABASE NAME"),
          ignored<R>("database type", "= exodusII", "The layout of restart files is contactsim's own"),
          row("overwrite", read::on_off, &R::overwrites, "Whether an existing file is replaced"),
          row("restart time", read::real, &R::restart_time,
              "Goes on from the state stored at that time [time]"),
          row<R>("restart", "= AUTOMATIC", read_automatic_restart,
                 "Goes on from the last state, if there is one", "off"),
          row("overlay count", read::non_negative_integer, &R::overlay_count,
              "States [1] that are overwritten before the next is kept"),
          row("cycle count", read::positive_integer, &R::cycle_count, "States [1] kept in a file", "all"),
          row("file cycle count", read::positive_integer, &R::file_cycle_count, "Files [1] kept", "one"),
          row<R>("at wall time", "<t0> {INCREMENT|INTERVAL} = <dt>", read_wall_time_phase,
                 "Writes by the clock: seconds, or with a unit 30s, 700m, 12h, 1d [s]", "none"),
          flag("optional", &R::is_optional, "A missing file is no error"),
          flag("shift to start time", &R::shifts_to_start_time, "Moves stored times to the run's start"),
      },
      lift_all(output_schedule_rows(), &R::schedule),
  }));
  return table;
}

}  // namespace contactsim

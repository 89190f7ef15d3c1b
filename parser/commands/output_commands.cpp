// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/output_commands.hpp"

#include <fmt/format.h>

#include "parser/commands/output_restart_commands.hpp"
#include "parser/commands/output_schedule_commands.hpp"
#include "parser/commands/output_variable_commands.hpp"
#include "parser/commands/row_lists.hpp"

namespace contactsim {

namespace {

void read_results_type(Arguments& arguments, OutputDatabase&) {
  const Word& type = arguments.word("exodusII");
  const std::string folded = fold(type.text);
  if (folded != "exodusii" && folded != "exodus" && folded != "genesis") {
    arguments.warn("deck-ignored", type, fmt::format("'{}' files are not written, Exodus is", type.text));
  }
}

void read_separator(Arguments& arguments, OutputDatabase& database) {
  const Word& character = arguments.word("a character or NONE");
  if (fold(character.text) == "none") {
    database.component_separator = "";
  } else if (character.text.size() == 1) {
    database.component_separator = character.text;
  } else {
    arguments.fail(character, fmt::format("expected one character or NONE for '{}', found '{}'",
                                          arguments.what(), character.text));
  }
}

std::vector<Row<OutputDatabase>> database_rows() {
  using D = OutputDatabase;
  return {
      row("database name", read::name, &D::name, "File to write; %B stands for the deck's base name",
          "the deck's base name and .e, or .h for history"),
      row<D>("database type", "= exodusII", read_results_type, "Format of the file", "exodusII"),
      row("overwrite", read::on_off, &D::overwrites, "Whether an existing file is replaced"),
      row("title", read::rest_of_line, &D::title, "Title in the file", "the deck's title"),
      row<D>("component separator character", "= {<character>|NONE}", read_separator,
             "Stands between a variable and its component", "_"),
      ignored<D>("property", "<name> = <value>", "The file's layout is contactsim's own"),
      ignored<D>("timeseries name", "= <file>", "Lists of files are not written"),
  };
}

const Table<ResultsOutput>& results_table() {
  using R = ResultsOutput;
  static const auto mesh = choice_of<R::OutputMesh>({"unrefined", "refined", "exposed surface"});
  static const Table<R> table(joined<R>({
      lift_all(database_rows(), &R::database),
      lift_all(output_schedule_rows(), &R::schedule),
      lift_all(variable_request_rows(RequestPlaces::parts), &R::variables),
      {
          row("include", read::names, &R::included, "Blocks and side sets to write", "all"),
          row("exclude", read::names, &R::excluded, "Blocks and side sets to leave out"),
          row("output mesh", mesh, &R::mesh, "What of the mesh is written"),
          ignored_block<R>("catalyst", "Pictures are not made during the run"),
      },
  }));
  return table;
}

const Table<HistoryOutput>& history_table() {
  using H = HistoryOutput;
  static const Table<H> table(joined<H>({
      lift_all(database_rows(), &H::database),
      lift_all(output_schedule_rows(), &H::schedule),
      lift_all(variable_request_rows(RequestPlaces::entities), &H::variables),
  }));
  return table;
}

const Table<HeartbeatOutput>& heartbeat_table() {
  using H = HeartbeatOutput;
  static const auto format = choice_of<H::Format>({"csv", "spyhis", "original"});
  static const auto monitored = choice_of<H::Monitored>({"results", "restart", "history"});
  static const Table<H> table(joined<H>({
      {
          row("stream name", read::name, &H::stream, "File to write, or cout, cerr, log, output",
              "the deck's base name and .csv"),
          row("format", format, &H::format, "Form of the lines"),
          row("append", read::on_off, &H::appends, "Whether an existing file is added to"),
          row("precision", read::positive_integer, &H::precision, "Digits of a number [1]", "6"),
          row("labels", read::on_off, &H::has_labels, "Names beside the numbers", "as the format"),
          row("legend", read::on_off, &H::has_legend, "Names on top", "as the format"),
          row("units line", read::on_off, &H::has_units,
              "Dimensions of the numbers under their names, such as force: decks have no units; contactsim's "
              "own "
              "line"),
          row("timestamp format", read::text, &H::timestamp_format,
              "Clock time in each line, as strftime takes it"),
          row("monitor", monitored, &H::monitored, "Writes a line whenever that output is written"),
          row<H>(
              "title", "<rest of the line>", [](Arguments& arguments, H&) { arguments.rest(); },
              "Not written to text", "none"),
      },
      lift_all(output_schedule_rows(), &H::schedule),
      lift_all(variable_request_rows(RequestPlaces::entities), &H::variables),
  }));
  return table;
}

/// Three public decks carry the spelling HEARTBEAT OUPUT, and they mean heartbeat output.
Row<Region> heartbeat_row() {
  Row<Region> made =
      block<Region, HeartbeatOutput>("heartbeat output", Naming::optional, heartbeat_table,
                                     &Region::heartbeat_outputs, "Single values over time, as text");
  made.text.spellings = {"heartbeat ouput"};
  made.read_block = [read_block = made.read_block](const Block& found, const DeckName& name, Region& region,
                                                   Binding& binding) {
    if (match_phrase(split_phrase("heartbeat ouput"), found.title) > 0) {
      const Word& word = found.title.front();
      binding.diagnostics.add_warning("deck-misspelt", word.location,
                                      "HEARTBEAT OUPUT is taken as HEARTBEAT OUTPUT", "",
                                      static_cast<int>(word.text.size()));
    }
    read_block(found, name, region, binding);
  };
  return made;
}

}  // namespace

std::vector<Row<Region>> output_rows() {
  using R = Region;
  return {
      block<R, ResultsOutput>("results output", Naming::optional, results_table, &R::results_outputs,
                              "Fields over time, to an Exodus file"),
      block<R, HistoryOutput>("history output", Naming::optional, history_table, &R::history_outputs,
                              "Single values over time, to an Exodus file"),
      heartbeat_row(),
      block<R, RestartData>("restart data", Naming::optional, restart_table, &R::restart_data,
                            "Files from which a run can be continued"),
  };
}

}  // namespace contactsim

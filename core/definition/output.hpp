// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/definition/output_schedule.hpp"
#include "core/definition/output_variable.hpp"

/// What a region writes. Source: Sierra/SM 5.22, chapter 9.
namespace contactsim {

/// The file of an output. %B in its name stands for the deck's base name.
struct OutputDatabase {
  std::optional<DeckName> name;  ///< DATABASE NAME, as in the deck; absent: made from the deck's name
  bool overwrites = true;        ///< whether an existing file is replaced
  std::string title;             ///< rest of the TITLE line; "": the deck's
  std::string component_separator = "_";  ///< between a variable and its component: displ_x; "" for NONE
};

/// BEGIN RESULTS OUTPUT [name]: fields of the mesh over time.
struct ResultsOutput {
  enum class OutputMesh : std::uint8_t { unrefined, refined, exposed_surface };

  DeckName name;
  OutputDatabase database;
  OutputSchedule schedule;
  std::vector<VariableRequest> variables;    ///< in deck order; place is WholeModel or NamedParts
  std::vector<DeckName> included, excluded;  ///< blocks and side sets; none included: all
  OutputMesh mesh = OutputMesh::unrefined;
};

/// BEGIN HISTORY OUTPUT [name]: single values over time, to an Exodus file.
struct HistoryOutput {
  DeckName name;
  OutputDatabase database;
  OutputSchedule schedule;
  std::vector<VariableRequest> variables;  ///< in deck order
};

/// BEGIN HEARTBEAT OUTPUT [name]: single values over time, as lines of text.
struct HeartbeatOutput {
  enum class Format : std::uint8_t { csv, spyhis, original };
  enum class Monitored : std::uint8_t { results, restart, history };

  DeckName name;
  std::optional<DeckName> stream;  ///< file name, or cout, stdout, cerr, clog, log, output, outputP0
  Format format = Format::csv;
  bool appends = false;                   ///< to an existing file
  std::optional<std::int64_t> precision;  ///< digits of a number, >= 1
  std::optional<bool> has_labels,
      has_legend;          ///< names beside the numbers, names on top; absent: as the format
  bool has_units = false;  ///< dimensions of the numbers under their names
  std::optional<std::string> timestamp_format;  ///< as strftime takes it; "" for none
  std::optional<Monitored> monitored;           ///< writes a line whenever that output is written
  OutputSchedule schedule;
  std::vector<VariableRequest> variables;  ///< in deck order
};

/// AT WALL TIME <start> INCREMENT = <increment>, in seconds of the clock.
struct WallTimePhase {
  double start = 0.0;      ///< >= 0 [s]
  double increment = 0.0;  ///< > 0 [s]
};

/// BEGIN RESTART DATA [name]. Source: Sierra/SM 5.26, restart.
struct RestartData {
  DeckName name;
  std::optional<DeckName> database;         ///< DATABASE NAME: read and written
  std::optional<DeckName> input_database;   ///< in place of `database` for reading
  std::optional<DeckName> output_database;  ///< in place of `database` for writing
  std::optional<double> restart_time;       ///< RESTART TIME: goes on from the state stored then [time]
  bool is_automatic = false;          ///< RESTART = AUTOMATIC: goes on from the last state, if there is one
  bool is_optional = false;           ///< OPTIONAL: a missing file is no error
  bool shifts_to_start_time = false;  ///< SHIFT TO START TIME: stored times are moved to the run's
  bool overwrites = true;             ///< whether an existing file is replaced
  std::optional<std::int64_t> overlay_count;  ///< states that are overwritten before the next is kept, >= 0
  std::optional<std::int64_t> cycle_count;    ///< states kept in a file, >= 1
  std::optional<std::int64_t> file_cycle_count;  ///< files kept, >= 1
  OutputSchedule schedule;
  std::vector<WallTimePhase> wall_time_phases;
};

}  // namespace contactsim

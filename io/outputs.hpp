// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/output/output_times.hpp"
#include "core/output/requested_fields.hpp"
#include "io/heartbeat_writer.hpp"
#include "io/results_writer.hpp"

namespace contactsim {

/// What the outputs of a run need besides deck and model.
struct OutputSettings {
  std::optional<std::string> results_path;  ///< in place of the deck's first results file
  std::string command_line;
  std::vector<std::string> deck_lines;  ///< after Aprepro
  TextSink log;                         ///< for heartbeats to cout, cerr, log, ...
  std::function<std::time_t()> clock = [] { return std::time(nullptr); };
};

/// All that a region writes while it runs: results, history and heartbeat. Files are made at the first call
/// of write(). Asking for output changes nothing in the run.
class Outputs {
 public:
  /// Reports requests that mean nothing (warnings), schedulers, nodes and elements that do not exist and two
  /// outputs to one file (errors). The variables and the mesh of their model must outlive it.
  Outputs(const SimulationDefinition& definition, const Region& region, const RunVariables& variables,
          OutputSettings settings, Diagnostics& diagnostics);

  /// Writes what is due; to be called for the state of the start and that after every step.
  ///   is_last  the run ends with this state
  /// Throws FileError.
  void write(const State& state, bool is_last);

  /// The files that are written, in the order of the deck.
  std::vector<std::string> paths() const;

 private:
  /// An Exodus file over the mesh, or without it for single values.
  struct ExodusJob {
    std::string path;
    bool overwrites = true, has_mesh = true;
    std::string title;
    OutputTimes times;
    RequestedFields fields;
    std::unique_ptr<ResultsWriter> writer;
  };
  struct HeartbeatJob {
    std::string path;  ///< "" for the log
    bool appends = false;
    std::optional<HeartbeatOutput::Monitored> monitored;
    bool has_schedule = false;
    OutputTimes times;
    RequestedFields values;
    HeartbeatStyle style;
    std::optional<HeartbeatWriter> writer;
  };

  void add_results(const SimulationDefinition& definition, const ResultsOutput& output,
                   std::optional<std::string> path, Diagnostics& diagnostics);
  void add_history(const SimulationDefinition& definition, const HistoryOutput& output,
                   Diagnostics& diagnostics);
  void add_heartbeat(const SimulationDefinition& definition, const HeartbeatOutput& output,
                     Diagnostics& diagnostics);
  void open_files();
  ResultsText make_text(const std::string& title) const;
  bool write_job(ExodusJob& job, const State& state, const RunMoment& now);

  const RunVariables& variables_;
  OutputSettings settings_;
  std::vector<std::vector<std::string>> block_names_;
  std::vector<ExodusJob> results_, histories_;
  std::vector<HeartbeatJob> heartbeats_;
  bool is_open_ = false;
};

}  // namespace contactsim

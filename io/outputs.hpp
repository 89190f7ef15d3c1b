// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/dynamics/time_step.hpp"
#include "core/output/output_times.hpp"
#include "core/output/requested_fields.hpp"
#include "core/output/termination.hpp"
#include "core/output/user_outputs.hpp"
#include "io/exodus/results_writer.hpp"
#include "io/heartbeat/heartbeat_writer.hpp"
#include "io/rigid_part.hpp"

namespace contactsim {

/// What the outputs of a run need besides deck and model.
struct OutputSettings {
  std::optional<std::string> results_path;  ///< in place of the deck's first results file
  std::string command_line;
  std::vector<std::string> deck_lines;    ///< after Aprepro
  TextSink log;                           ///< for heartbeats to cout, cerr, log, ...
  std::vector<OutputVariable> variables;  ///< of contact, besides those of every run
  std::vector<SideSet> side_sets;         ///< that results files hold besides those of the mesh
  bool always_computes = false;           ///< someone reads what the deck computes after every step
  std::function<std::time_t()> clock = [] { return std::time(nullptr); };
};

/// All that a region writes while it runs: results, history and heartbeat. Files are made at the first call
/// of write(). Asking for output changes nothing in the run.
class Outputs {
 public:
  /// Reports requests that mean nothing (warnings), schedulers, nodes, elements and functions that do not
  /// exist and two outputs to one file (errors). The model and its mesh must outlive it.
  Outputs(const ConditionScope& scope, const Model& model, OutputSettings settings);
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  /// Brings what the deck computes to the state, and says whether a SOLUTION TERMINATION ends the run with
  /// it: why, in words. To be called once for the state of the start and that after every step, before
  /// write().
  std::optional<std::string> check_termination(const State& state);

  /// Writes what is due.
  ///   is_last  the run ends with this state
  /// Throws FileError.
  void write(const State& state, bool is_last);

  /// Writes heartbeats that MONITOR = RESTART, once a restart file is there. Throws FileError.
  void write_at_restart(const State& state);

  /// The times at which outputs with a TIMESTEP ADJUSTMENT INTERVAL want steps to end.
  std::vector<StepTarget> step_targets() const;

  /// Gives the names of all files an end; heartbeats that append go on with theirs. Precedes write().
  void add_suffix(const std::string& suffix);
  /// Passes over what an earlier run has written up to a state.
  void resume(const State& state) { find_due({state.step, state.time, false}); }
  /// Saves or restores what user variables hold.
  void archive(StateArchive& saved) { user_outputs_.archive(saved); }
  /// All that can be written, for who reads variables too.
  const OutputVariables& variables() const { return variables_; }

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
    std::vector<OutputField> defined;  ///< as `fields`, once the file is open
    std::unique_ptr<ResultsWriter> writer;
    bool is_due = false;
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
    bool is_due = false;
    std::optional<std::int64_t> last_step = std::nullopt;  ///< that was written

    void write(const State& state, const OutputContext& context);
  };

  void add_results(const ConditionScope& scope, const ResultsOutput& output, std::optional<std::string> path);
  void add_history(const ConditionScope& scope, const HistoryOutput& output);
  void add_heartbeat(const ConditionScope& scope, const HeartbeatOutput& output);
  void open_files();
  ResultsText make_text(const std::string& title) const;
  bool find_due(const OutputTime& now);

  const Model& model_;
  RigidPart rigid_part_;
  OutputVariables variables_;
  UserOutputs user_outputs_;
  Terminations terminations_;
  OutputSettings settings_;
  std::vector<std::vector<std::string>> block_names_;
  std::vector<ExodusJob> exodus_;  // results, then histories
  std::vector<HeartbeatJob> heartbeats_;
  bool is_open_ = false;
};

}  // namespace contactsim

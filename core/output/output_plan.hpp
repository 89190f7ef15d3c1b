// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/dynamics/rank_share.hpp"
#include "core/dynamics/time_step.hpp"
#include "core/output/planned_files.hpp"
#include "core/output/rigid_part.hpp"
#include "core/output/termination.hpp"
#include "core/output/user_outputs.hpp"

namespace contactsim {

/// What the outputs of a run need besides deck and model.
struct OutputSettings {
  OutputWriters writers;
  std::optional<std::string> results_path;  ///< in place of the deck's first results file
  std::vector<OutputVariable> variables;    ///< of contact, besides those of every run
  OutputNames other_names;                  ///< groups of variables, and names that others give them
  std::vector<SideSet> side_sets;           ///< that results files hold besides those of the mesh
  std::vector<NodeSet> node_sets;           ///< likewise
  bool always_computes = false;             ///< someone reads what the deck computes after every step
  /// Called before values of a state are read: what other ranks know of it has to arrive.
  std::function<void()> complete_state = [] {};
};

/// What a file of a run would come to.
struct OutputEstimate {
  std::string path;
  std::int64_t n_states = 0;  ///< steps or lines
  std::uint64_t n_bytes = 0;
};

/// Says what a region writes while it runs and when: results, history and heartbeat; and when it ends. Files
/// are opened at the first call of write(). Asking for output changes nothing in the run.
class OutputPlan {
 public:
  /// Reports requests that mean nothing (warnings), schedulers, nodes, elements and functions that do not
  /// exist and two outputs to one file (errors). The model and its mesh must outlive it.
  OutputPlan(const ConditionScope& scope, const Model& model, OutputSettings settings);
  OutputPlan(const OutputPlan&) = delete;
  OutputPlan& operator=(const OutputPlan&) = delete;

  /// On several ranks, which each know their own nodes and elements between two calls of
  /// OutputSettings::complete_state. The share must outlive it. Precedes all that is called on every rank.
  void share_among(const RankShare& share) { share_ = &share; }

  /// Brings what the deck computes to the state, and says whether a SOLUTION TERMINATION ends the run with
  /// it. To be called once for the state of the start and that after every step, before write().
  std::optional<EarlyEnd> check_termination(const State& state);
  /// The same of a state that has been restored, whose user variables are those of its step already.
  std::optional<EarlyEnd> check_restored_termination(const State& state) const;

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
  /// The names that the deck gives them, of which results files in pieces make theirs.
  std::vector<std::string> names() const;
  /// What they would hold after steps of one size from a time on, but for lines of MONITOR = RESTART. Not to
  /// be written to afterwards. Precondition: the writers can measure.
  ///   step  [time]
  std::vector<OutputEstimate> estimate(double begin, double step, std::int64_t n_steps);

 private:
  struct Results {
    PlannedResults plan;
    std::vector<OutputField> defined;  ///< the plan's fields, once the file is open
    OutputWriters::OpenResults open;
    bool is_due = false;
  };
  struct Heartbeat {
    PlannedHeartbeat plan;
    OutputWriters::AppendLine append;
    bool is_due = false;
    std::optional<std::int64_t> last_step;  ///< that was written

    void write(const OutputContext& context);
  };

  template <class NamesOf>
  std::vector<std::string> list_files(const NamesOf& names_of) const;
  /// The mesh of results: with the sets and the rigid part that a run adds.
  Mesh results_mesh() const;
  void open_files();
  bool find_due(const OutputTime& now);
  /// Whether what is due reads more than each rank knows of a state.
  bool reads_whole_state() const;
  void write(Results& results, const OutputContext& context);
  void write_single_values(Results& results, const OutputContext& context) const;
  std::span<const double> values_of(Results& results, std::size_t field, const OutputContext& context);

  const Model& model_;
  const RankShare* share_ = nullptr;
  RigidPart rigid_part_;
  OutputVariables variables_;
  UserOutputs user_outputs_;
  Terminations terminations_;
  OutputSettings settings_;
  std::vector<Results> results_;  // then histories
  std::vector<Heartbeat> heartbeats_;
  bool is_open_ = false;
};

}  // namespace contactsim

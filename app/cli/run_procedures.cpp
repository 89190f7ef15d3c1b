// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_procedures.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

#include "app/reports/procedure_report.hpp"
#include "app/reports/run_head.hpp"
#include "app/reports/run_log.hpp"
#include "app/run/run_restart.hpp"
#include "app/run/simulation.hpp"
#include "core/base/memory_error.hpp"

namespace contactsim {

namespace {

using Simulations = std::vector<std::unique_ptr<Simulation>>;

/// Has the run do what signals ask for.
void obey(StopSignals& signals, Simulation& simulation) {
  if (const auto signal = signals.find_stop()) simulation.stop(*signal);
  if (signals.take_restart_wish()) simulation.store_restart();
}

/// The loop of a run.
ExitCode run_steps(Simulation& simulation, StopSignals& signals) {
  ExitCode code = ExitCode::done;
  simulation.stop_when([&signals] { return signals.find_stop(); });
  try {
    simulation.begin();
    obey(signals, simulation);
    while (!simulation.is_over()) {
      simulation.step();
      obey(signals, simulation);
    }
  } catch (const SolveError&) {
    code = ExitCode::solve;
  }
  simulation.finish();
  return simulation.stopped_by() ? ExitCode::stopped : code;
}

ExitCode run_to_end(Simulation& simulation, StopSignals& signals, RunSummary& summary) {
  try {
    const ExitCode code = tell_lack_of_memory("running", [&] { return run_steps(simulation, signals); });
    note_run(simulation, summary);
    return code;
  } catch (...) {
    note_run(simulation, summary);
    throw;
  }
}

/// One region's run of several.
class ProcedureRuns {
 public:
  ProcedureRuns(const DeckWay& way, std::span<const PreparedRegion> regions) : way_(way), regions_(regions) {}

  /// Sets all of them up.
  void make() {
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      RunInput input = regions_[i].input(way_.definition);
      if (i > 0) input.earlier = simulations_.back().get();
      simulations_.push_back(tell_lack_of_memory("setting the run up", [&] {
        return std::make_unique<Simulation>(input, settings(i), way_.warnings);
      }));
      way_.signals.end_if_stopped();
    }
  }

  ExitCode estimate() {
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      write_heading(i);
      const RunEstimate estimate = simulations_[i]->estimate();
      way_.log.write(format_estimate(estimate));
      way_.log.write_to_file(format_estimated_time(estimate, omp_get_max_threads()));
    }
    return ExitCode::done;
  }

  ExitCode run() {
    for (const auto& simulation : simulations_)
      std::ranges::copy(simulation->output_paths(), std::back_inserter(way_.draft.output_paths));
    const std::size_t first = find_resumed();
    for (std::size_t i = 0; i < first; ++i)
      way_.log.write(fmt::format("\nThe procedure {} is not run: {} goes on from its stored state.\n",
                                 regions_[i].procedure.name.text, regions_[first].procedure.name.text));
    for (std::size_t i = first + 1; i < regions_.size(); ++i) simulations_[i]->begin_at_start();
    for (std::size_t i = first; i < regions_.size(); ++i) {
      write_heading(i);
      const ExitCode code = run(i);
      const auto& end = simulations_[i]->end();
      if (code != ExitCode::done || (end && !end->ends_procedure_alone)) {
        write_left_out(i + 1);
        return code;
      }
      if (i > 0) simulations_[i - 1].reset();
    }
    return ExitCode::done;
  }

 private:
  /// The procedure that goes on from a stored state: of those that have one the last of the run that began
  /// last, or that of the state next to RESTART TIME; the first without any.
  std::size_t find_resumed() const {
    std::size_t resumed = 0;
    std::optional<StoredState> best;
    double nearest = 0.0;
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      const RunRestart& restart = simulations_[i]->restart();
      const std::optional<StoredState> state = restart.find_best();
      if (!state) continue;
      const double distance = restart.distance_to(*state);
      const bool is_better =
          !best || distance < nearest || (distance == nearest && state->head.begun >= best->head.begun);
      if (!is_better) continue;
      best = state;
      nearest = distance;
      resumed = i;
    }
    return resumed;
  }

  bool are_several() const { return regions_.size() > 1; }

  /// The command line's results file is that of the last procedure.
  RunSettings settings(std::size_t i) const {
    const Options& options = way_.options;
    std::vector<RunFile> kept = files_read(options);
    kept.push_back({regions_[i].mesh->path(), "the mesh"});
    for (RunFile& file : files_written(options)) {
      if (file.path != options.results) kept.push_back(std::move(file));
    }
    const bool is_last = i + 1 == regions_.size();
    return {is_last ? options.results : std::nullopt,
            options.command_line,
            std::move(kept),
            [&log = way_.log](std::string_view text) { log.write(text); },
            !is_last && !regions_[i + 1].procedure.transfers.empty(),
            way_.ranks,
            options.writes_pieces};
  }

  void write_heading(std::size_t i) {
    if (!are_several()) return;
    const PreparedRegion& of = regions_[i];
    way_.log.write(format_procedure(of.procedure, of.region, i > 0 ? &regions_[i - 1].procedure : nullptr));
  }

  ExitCode run(std::size_t i) {
    Simulation& simulation = *simulations_[i];
    RunLog run_log(way_.log);
    simulation.observe([&](RunEvent event, const Simulation& run) { run_log.look(event, run); });
    if (way_.options.report)
      simulation.observe([&](RunEvent event, const Simulation& run) { way_.draft.curves.look(event, run); });
    RunSummary& summary = way_.summary;
    if (summary.run) summary.earlier_runs.push_back(std::move(*summary.run));
    return run_to_end(simulation, way_.signals, summary);
  }

  void write_left_out(std::size_t first) {
    for (std::size_t i = first; i < regions_.size(); ++i)
      way_.log.write(fmt::format("\nThe procedure {} is not run.\n", regions_[i].procedure.name.text));
  }

  const DeckWay& way_;
  std::span<const PreparedRegion> regions_;
  Simulations simulations_;
};

}  // namespace

ExitCode run_procedures(const DeckWay& way, std::span<const PreparedRegion> regions) {
  ProcedureRuns runs(way, regions);
  runs.make();
  if (way.options.stage == Stage::check) return runs.estimate();
  if (way.options.is_strict && !way.warnings.empty()) return ExitCode::done;
  return runs.run();
}

}  // namespace contactsim

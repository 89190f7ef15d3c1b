// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_sweep.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "app/cli/read_run_deck.hpp"
#include "app/cli/run_mesh.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/compare/read_number.hpp"
#include "app/reports/run_summary.hpp"
#include "app/sweep/sweep.hpp"
#include "core/base/errors.hpp"
#include "core/base/pluralize.hpp"

namespace contactsim {

namespace {

namespace fs = std::filesystem;

/// Makes the requests of the runs of one deck; meshes are read once.
class RequestMaker {
 public:
  RequestMaker(const SweepOptions& options, int n_threads) : options_(options), n_threads_(n_threads) {
    program_ = fs::read_symlink("/proc/self/exe").string();
  }

  RunRequest operator()(const SweepPoint& point) {
    RunRequest request;
    request.words = {program_, fs::absolute(options_.deck).string()};
    DeckRequest deck{options_.deck, {}, options_.is_lenient, std::nullopt};
    for (const auto& [name, value] : point) deck.definitions.push_back(name + "=" + value);
    if (const auto mesh = find_mesh(deck, request)) {
      request.words.push_back(fs::absolute(*mesh).string());
      request.mesh_digest = mesh_digest(*mesh);
    }
    for (const std::string& definition : deck.definitions) {
      request.words.push_back("-D");
      request.words.push_back(definition);
    }
    request.words.insert(request.words.end(), {"--includes-from", fs::current_path().string()});
    if (n_threads_ > 0) request.words.insert(request.words.end(), {"--threads", fmt::to_string(n_threads_)});
    if (options_.is_lenient) request.words.push_back("--lenient");
    return request;
  }

 private:
  /// The mesh that the run would read, from here; a deck that is wrong says so in its run.
  std::optional<std::string> find_mesh(const DeckRequest& request, RunRequest& run) const {
    try {
      Diagnostics found;
      const RunDeck deck = read_run_deck(request, found);
      if (found.has_errors()) return options_.mesh;
      run.deck_digest = format_digest(deck.digest);
      Options of_run;
      of_run.mesh = options_.mesh;
      return run_mesh_path(of_run, deck.definition, choose_region(deck.definition, true, found).region);
    } catch (const DeckError&) {
      return options_.mesh;
    } catch (const FileError&) {
      return options_.mesh;
    }
  }

  const std::string& mesh_digest(const std::string& path) {
    const auto [found, is_new] = mesh_digests_.try_emplace(path);
    if (is_new) found->second = digest_of_files(list_mesh_files(path));
    return found->second;
  }

  const SweepOptions& options_;
  int n_threads_;
  std::string program_;
  std::map<std::string, std::string> mesh_digests_;
};

std::vector<SweepRun> list_runs_of(const SweepOptions& options) {
  SweepPlan plan;
  for (const std::string& definition : options.definitions)
    plan.parameters.push_back(parse_sweep_parameter(definition));
  plan.points_file = options.points;
  plan.n_samples = options.n_samples;
  plan.seed = options.seed;
  plan.max_runs = options.max_runs;
  return list_runs(plan);
}

/// The run that --array names.
const SweepRun& find_array_run(const std::string& array, const std::vector<SweepRun>& runs) {
  std::string text = array;
  if (array == "slurm") {
    const char* id = std::getenv("SLURM_ARRAY_TASK_ID");
    if (id == nullptr) refuse_sweep("--array slurm: SLURM_ARRAY_TASK_ID is not set");
    text = id;
  }
  const auto number = read_integer(text);
  if (!number) refuse_sweep(fmt::format("--array {}: '{}' is no number of a run", array, text));
  if (*number < 1 || *number > static_cast<std::int64_t>(runs.size()))
    refuse_sweep(
        fmt::format("--array {}: there is no run {}, they are 1 to {}", array, *number, runs.size()));
  return runs[static_cast<std::size_t>(*number - 1)];
}

void print_line(std::string_view line) {
  std::fwrite(line.data(), 1, line.size(), stdout);
  std::fputc('\n', stdout);
  std::fflush(stdout);
}

/// Threads of each run; 0 leaves it to OpenMP, as for one run of an array, whose scheduler knows.
int threads_per_run(const SweepOptions& options) {
  if (options.n_threads > 0 || options.array) return options.n_threads;
  return std::max(1, omp_get_num_procs() / static_cast<int>(options.n_jobs));
}

int run_all(const std::vector<SweepRun>& runs, const SweepSettings& settings) {
  print_line(fmt::format("{} in {}", pluralize(runs.size(), "run"), settings.folder));
  const SweepOutcome outcome = run_sweep_of(runs, settings);
  for (const auto& [text, n] : outcome.unused)
    std::fprintf(stderr, "warning: %s (%s)\n", text.c_str(), pluralize(n, "run").c_str());
  std::string line = fmt::format("{} done", outcome.n_done + outcome.n_kept);
  if (outcome.n_kept > 0) line += fmt::format(" ({} of them before)", outcome.n_kept);
  line += fmt::format(", {} failed", outcome.n_failed);
  if (outcome.n_stopped > 0) line += fmt::format(", {} stopped", outcome.n_stopped);
  if (outcome.n_left > 0) line += fmt::format(", {} not begun", outcome.n_left);
  print_line(line + "; " + (fs::path(settings.folder) / "study.csv").string());
  return outcome.is_stopped ? static_cast<int>(ExitCode::stopped) : outcome.first_failure;
}

int sweep(const SweepOptions& options) {
  if (!fs::is_regular_file(options.deck)) throw FileError(options.deck, "there is no such deck");
  const std::vector<SweepRun> runs = list_runs_of(options);
  if (options.lists) {
    for (const SweepRun& run : runs)
      print_line(fmt::format("{}\t{}\t{}", run.number, run.folder, describe_point(run.point)));
    return 0;
  }
  StopSignals signals;
  RequestMaker make_request(options, threads_per_run(options));
  const SweepSettings settings{options.folder,
                               fs::path(options.deck).stem().string(),
                               options.n_jobs,
                               [&](const SweepPoint& point) { return make_request(point); },
                               [&] { return signals.find_stop().has_value(); },
                               print_line};
  if (options.array) {
    const SweepRun& run = find_array_run(*options.array, runs);
    const int code = run_one_of(run, settings);
    print_line(fmt::format("run {} of {}, {}: exit code {}; {}", run.number, runs.size(),
                           describe_point(run.point), code,
                           (fs::path(options.folder) / run.folder).string()));
    return code;
  }
  if (!options.collects) return run_all(runs, settings);
  collect_study(runs, settings);
  return 0;
}

}  // namespace

int run_sweep(const SweepOptions& options) {
  try {
    return sweep(options);
  } catch (const DeckError& error) {
    for (const Diagnostic& mistake : error.diagnostics().all())
      std::fprintf(stderr, "error: %s\n", mistake.text.c_str());
    return static_cast<int>(ExitCode::deck);
  }
}

}  // namespace contactsim

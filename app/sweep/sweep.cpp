// SPDX-License-Identifier: BSD-3-Clause
#include "app/sweep/sweep.hpp"

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "app/sweep/child_processes.hpp"
#include "app/sweep/study_files.hpp"
#include "core/base/errors.hpp"
#include "io/files/write_text.hpp"

namespace contactsim {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// How often ended runs and stops are looked for: little beside the shortest run.
constexpr std::chrono::milliseconds pause{5};
/// What a run writes to standard error: warnings and errors, those of its command line too.
constexpr const char* messages_name = "messages.txt";

std::string folder_path(const SweepRun& run, const SweepSettings& settings) {
  return (fs::path(settings.folder) / run.folder).string();
}

void make_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw FileError(path, "the folder cannot be made (" + error.message() + ")");
}

bool is_done_already(const SweepRun& run, const RunRequest& request, const SweepSettings& settings) {
  const auto record = read_record(folder_path(run, settings), run.point);
  return record && record->state == "done" && !request.deck_digest.empty() &&
         record->deck_digest == request.deck_digest && record->mesh_digest == request.mesh_digest;
}

void start_run(const SweepRun& run, const RunRequest& request, const SweepSettings& settings,
               ChildProcesses& children) {
  const std::string folder = folder_path(run, settings);
  make_folder(folder);
  std::error_code ignored;
  // What an earlier run left must not be taken for what this one says.
  fs::remove(fs::path(folder) / summary_name, ignored);
  ChildCommand command{request.words, folder, (fs::path(folder) / messages_name).string()};
  command.words.insert(command.words.end(), {"--summary", summary_name});
  children.start(run.number, command);
}

void drop_empty_messages(const SweepRun& run, const SweepSettings& settings) {
  const fs::path messages = fs::path(folder_path(run, settings)) / messages_name;
  std::error_code ignored;
  if (fs::is_empty(messages, ignored)) fs::remove(messages, ignored);
}

std::string duration(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

/// Whether a run was stopped: after a step, or by the same signal before its first.
bool is_stop(int exit_code) {
  return exit_code == static_cast<int>(ExitCode::stopped) || exit_code == 128 + SIGTERM;
}

/// A sweep under way.
class Sweep {
 public:
  Sweep(const std::vector<SweepRun>& runs, const SweepSettings& settings)
      : runs_(runs), settings_(settings) {}

  SweepOutcome run() {
    while (has_more() || children_.n_running() > 0) {
      obey_stop();
      if (has_more() && children_.n_running() < settings_.n_jobs) {
        begin_next();
        continue;
      }
      if (const auto ended = children_.take_ended()) {
        note_end(*ended);
      } else {
        std::this_thread::sleep_for(pause);
      }
    }
    outcome_.n_left = runs_.size() - next_;
    if (!failures_.empty()) outcome_.first_failure = failures_.begin()->second;
    return outcome_;
  }

 private:
  bool has_more() const { return !outcome_.is_stopped && next_ < runs_.size(); }

  void obey_stop() {
    if (outcome_.is_stopped || !settings_.wants_stop()) return;
    outcome_.is_stopped = true;
    children_.send(SIGTERM);
  }

  void begin_next() {
    const SweepRun& run = runs_[next_++];
    const RunRequest request = settings_.make_request(run.point);
    if (is_done_already(run, request, settings_)) {
      ++outcome_.n_kept;
      return;
    }
    start_run(run, request, settings_, children_);
    begun_[run.number] = Clock::now();
  }

  void note_end(const EndedChild& ended) {
    const SweepRun& run = runs_[ended.number - 1];
    drop_empty_messages(run, settings_);
    ++n_ended_;
    const char* how = count_end(ended);
    const std::chrono::duration<double> took = Clock::now() - begun_[ended.number];
    std::string line =
        fmt::format("{:>6} of {}  {}: {}", run.number, runs_.size(), describe_point(run.point), how);
    if (ended.exit_code != 0) line += fmt::format(", exit code {}", ended.exit_code);
    settings_.write_line(line + fmt::format(" in {:.2f} s{}", took.count(), time_left()));
  }

  /// Returns how the run ended, in a word.
  const char* count_end(const EndedChild& ended) {
    if (ended.exit_code == 0) {
      ++outcome_.n_done;
      return "done";
    }
    failures_[ended.number] = ended.exit_code;
    const bool is_stopped = is_stop(ended.exit_code);
    ++(is_stopped ? outcome_.n_stopped : outcome_.n_failed);
    return is_stopped ? "stopped" : "failed";
  }

  /// By the mean of the runs that have ended, for those that have not.
  std::string time_left() const {
    const std::size_t n_left = runs_.size() - next_ + children_.n_running();
    if (n_left == 0 || outcome_.is_stopped) return "";
    const std::chrono::duration<double> elapsed = Clock::now() - start_;
    return fmt::format(
        ", {} left", duration(elapsed.count() / static_cast<double>(n_ended_) * static_cast<double>(n_left)));
  }

  const std::vector<SweepRun>& runs_;
  const SweepSettings& settings_;
  ChildProcesses children_;
  SweepOutcome outcome_;
  std::map<std::size_t, int> failures_;  // exit codes by number
  std::map<std::size_t, Clock::time_point> begun_;
  std::size_t next_ = 0, n_ended_ = 0;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

std::vector<std::optional<RunRecord>> collect_study(const std::vector<SweepRun>& runs,
                                                    const SweepSettings& settings) {
  std::vector<std::optional<RunRecord>> records;
  for (const SweepRun& run : runs) records.push_back(read_record(folder_path(run, settings), run.point));
  make_folder(settings.folder);
  const fs::path folder(settings.folder);
  write_text((folder / "study.csv").string(), format_study_csv(runs, records));
  write_text((folder / "study.xml").string(), format_study_xml(settings.name, runs, records));
  return records;
}

SweepOutcome run_sweep_of(const std::vector<SweepRun>& runs, const SweepSettings& settings) {
  collect_study(runs, settings);  // shows that it can be written, before hours of runs
  SweepOutcome outcome = Sweep(runs, settings).run();
  for (const auto& record : collect_study(runs, settings)) {
    if (record && !record->unused.empty()) ++outcome.unused[record->unused];
  }
  return outcome;
}

int run_one_of(const SweepRun& run, const SweepSettings& settings) {
  const RunRequest request = settings.make_request(run.point);
  if (is_done_already(run, request, settings)) return 0;
  ChildProcesses children;
  start_run(run, request, settings, children);
  for (bool is_stopped = false;;) {
    if (const auto ended = children.take_ended()) {
      drop_empty_messages(run, settings);
      return ended->exit_code;
    }
    if (!is_stopped && settings.wants_stop()) {
      is_stopped = true;
      children.send(SIGTERM);
    }
    std::this_thread::sleep_for(pause);
  }
}

}  // namespace contactsim

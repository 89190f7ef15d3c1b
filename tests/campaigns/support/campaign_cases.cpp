// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/support/campaign_cases.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <new>
#include <thread>

#include "campaigns/support/campaign_progress.hpp"
#include "campaigns/support/crash_report.hpp"

namespace contactsim::test {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t max_findings = 100, max_kept_of_libraries = 20;

class ForkedCampaign {
 public:
  ForkedCampaign(const CampaignOptions& options, const CaseLimits& limits, CampaignCases& cases)
      : options_(options), limits_(limits), cases_(cases), start_(Clock::now()) {
    progress_->next = options_.first;
    report_ = std::tmpfile();
    if (report_ == nullptr) throw std::bad_alloc();
  }

  int run();

 private:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  bool is_over() const;
  [[noreturn]] void run_child();
  std::string harm_of(std::uint64_t number);
  /// Waits for a child; returns why it was ended, "" when it ended by itself.
  std::string await(pid_t child, int& status) const;
  void judge_end(int status, const std::string& why_ended);
  /// Keeps what ran; the folder.
  std::string keep(std::uint64_t number, const std::string& text, const std::string& report);
  void tell(std::uint64_t number, const std::string& text, const std::string& report);
  std::string take_report() const;

  const CampaignOptions& options_;
  const CaseLimits& limits_;
  CampaignCases& cases_;
  Clock::time_point start_;
  Progress* progress_ = make_shared_progress();
  std::FILE* report_ = nullptr;  ///< the standard error of children
  std::uint64_t n_of_libraries_ = 0;
};

bool ForkedCampaign::is_over() const {
  if (progress_->n_findings >= max_findings || progress_->is_stopped) return true;
  if (options_.count) return progress_->next >= options_.first + *options_.count;
  return seconds() >= options_.seconds;
}

std::string ForkedCampaign::harm_of(std::uint64_t number) {
  try {
    return cases_.run(number);
  } catch (...) {
    return describe_exception();
  }
}

void ForkedCampaign::run_child() {
  dup2(fileno(report_), STDERR_FILENO);
  install_crash_report();
  // Sanitizers take terabytes of addresses for themselves and have a limit of their own.
  const rlimit addresses{3 * limits_.bytes, 3 * limits_.bytes};
  if (!is_sanitized()) setrlimit(RLIMIT_AS, &addresses);
  std::uint64_t allowed = peak_bytes() + limits_.bytes;
  for (std::uint64_t i = 0; i < limits_.cases_per_process && !is_over(); ++i) {
    progress_->is_in_case = true;
    std::string harm = harm_of(progress_->next);
    if (const std::uint64_t peak = peak_bytes(); harm.empty() && peak > allowed) {
      harm = "took " + std::to_string(peak >> 20) + " MiB of memory";
      allowed = peak + limits_.bytes;
    }
    if (!harm.empty()) tell(progress_->next, harm, "");
    ++progress_->n_done;
    ++progress_->next;
    progress_->is_in_case = false;
  }
  std::fflush(stdout);
  std::exit(0);  // leaks are looked for
}

std::string ForkedCampaign::await(pid_t child, int& status) const {
  clockid_t clock{};
  const bool has_clock = clock_getcpuclockid(child, &clock) == 0;
  const auto used = [&] {
    timespec time{};
    if (!has_clock || clock_gettime(clock, &time) != 0) return 0.0;
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double limit = is_sanitized() ? limits_.seconds_sanitized : limits_.seconds;
  constexpr double idle_limit = 300.0;  // a case that waits takes no time of the processor
  std::uint64_t seen = ~std::uint64_t{0};
  double used_before = 0.0, seconds_before = 0.0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    const std::uint64_t now = progress_->next;
    if (now != seen || !progress_->is_in_case) {
      seen = now;
      used_before = used();
      seconds_before = seconds();
    } else if (used() - used_before > limit || seconds() - seconds_before > idle_limit) {
      kill(child, SIGABRT);  // it says where it is
      for (int i = 0; i < 200 && waitpid(child, &status, WNOHANG) == 0; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      if (kill(child, SIGKILL) == 0) waitpid(child, &status, 0);
      return "took more than " + std::to_string(limit) + " s of the processor";
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return "";
}

std::string ForkedCampaign::take_report() const {
  std::string text;
  std::rewind(report_);
  for (int c = std::fgetc(report_); c != EOF; c = std::fgetc(report_)) text += static_cast<char>(c);
  std::rewind(report_);
  if (ftruncate(fileno(report_), 0) != 0) std::perror("campaign");
  return text;
}

void ForkedCampaign::judge_end(int status, const std::string& why_ended) {
  const std::string report = take_report();
  const bool is_whole = WIFEXITED(status) && WEXITSTATUS(status) == 0 && !progress_->is_in_case;
  if (is_whole) return;
  std::string text = why_ended;
  if (text.empty()) {
    text = WIFSIGNALED(status) ? "ended by signal " + std::to_string(WTERMSIG(status))
                               : "ended with code " + std::to_string(WEXITSTATUS(status));
  }
  if (const std::string headline = headline_of(report); !headline.empty()) text += ": " + headline;
  if (!progress_->is_in_case) {
    tell(progress_->next, "after the cases before it: " + text, report);
    return;
  }
  if (is_of_file_library(report)) {
    if (++n_of_libraries_ <= max_kept_of_libraries) keep(progress_->next, "in a library: " + text, report);
  } else {
    tell(progress_->next, text, report);
  }
  ++progress_->n_done;
  ++progress_->next;
  progress_->is_in_case = false;
}

std::string ForkedCampaign::keep(std::uint64_t number, const std::string& text, const std::string& report) {
  const std::filesystem::path folder =
      options_.keep / ("seed_" + std::to_string(options_.seed) + "_case_" + std::to_string(number));
  std::filesystem::create_directories(folder);
  cases_.keep(number, folder);
  std::ofstream(folder / "finding.txt") << text << '\n' << report;
  return folder.string();
}

void ForkedCampaign::tell(std::uint64_t number, const std::string& text, const std::string& report) {
  ++progress_->n_findings;
  const std::string folder = keep(number, text, report);
  std::printf("finding, seed %llu case %llu: %s (files in %s)\n",
              static_cast<unsigned long long>(options_.seed), static_cast<unsigned long long>(number),
              text.c_str(), folder.c_str());
  std::fflush(stdout);
}

int ForkedCampaign::run() {
  while (!is_over()) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child < 0) throw std::bad_alloc();
    if (child == 0) run_child();
    int status = 0;
    const std::string why_ended = await(child, status);
    judge_end(status, why_ended);
  }
  const std::string of_libraries =
      n_of_libraries_ == 0 ? "" : ", " + std::to_string(n_of_libraries_) + " ends in netCDF or HDF5";
  std::printf("campaign %s: %llu cases%s, %llu findings, seed %llu, %.1f s\n", options_.name.c_str(),
              static_cast<unsigned long long>(progress_->n_done), of_libraries.c_str(),
              static_cast<unsigned long long>(progress_->n_findings),
              static_cast<unsigned long long>(options_.seed), seconds());
  return progress_->n_findings > 0 ? 1 : 0;
}

/// Runs kept files in this process, so that a debugger sees what they do.
int replay_files(const CampaignOptions& options, CampaignCases& cases) {
  int code = 0;
  for (const std::filesystem::path& file : options.replayed) {
    const std::string harm = cases.replay(file);
    std::printf("%s: %s\n", file.c_str(), harm.empty() ? "no harm" : harm.c_str());
    if (!harm.empty()) code = 1;
  }
  return code;
}

}  // namespace

int run_campaign(const CampaignOptions& options, const CaseLimits& limits, CampaignCases& cases) {
  if (!options.replayed.empty()) return replay_files(options, cases);
  if (!options.is_to_write) return ForkedCampaign(options, limits, cases).run();
  for (std::uint64_t i = 0; i < options.count.value_or(1); ++i) {
    const std::filesystem::path folder = options.keep / std::to_string(options.first + i);
    std::filesystem::create_directories(folder);
    cases.keep(options.first + i, folder);
  }
  return 0;
}

}  // namespace contactsim::test

// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/run_head.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <fstream>

#include "app/reports/text_table.hpp"

namespace contactsim {

namespace {

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

/// What the system calls its first processor.
std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

/// Of this program now [MiB]; 0 where the system does not tell.
double resident_memory() {
  std::ifstream sizes("/proc/self/statm");
  double all = 0.0, resident = 0.0;
  sizes >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

}  // namespace

std::string format_run_head(const std::string& command_line, std::span<const std::string> definitions,
                            int n_ranks, int n_threads) {
  const std::time_t now = std::time(nullptr);
  std::string text =
      fmt::format("  date       {:%Y-%m-%d %H:%M:%S} UTC\n  command    {}\n", fmt::gmtime(now), command_line);
  if (!definitions.empty()) text += fmt::format("  variables  {}\n", fmt::join(definitions, " "));
  if (n_ranks > 1) text += fmt::format("  ranks      {}\n", n_ranks);
  return text + fmt::format("  host       {}, {} of {} processors, {}\n", host_name(), n_threads,
                            sysconf(_SC_NPROCESSORS_ONLN), processor_name());
}

std::string format_estimate(const RunEstimate& estimate) {
  const std::string stable =
      estimate.stable_step > 0.0 ? fmt::format("stable time step  {:.6g}, ", estimate.stable_step) : "load ";
  std::string text = fmt::format(
      "\nA run of this deck\n"
      "  {}steps of {:.6g} at the start\n"
      "  steps             {}, of {} elements: {:.3g} element-steps\n",
      stable, estimate.step, estimate.n_steps, estimate.n_elements, estimate.element_steps());
  if (estimate.files.empty()) return text;
  TextTable table(2, 1, {name_column("file", 40), {"steps", 9}, {"bytes", 15}});
  std::uint64_t n_bytes = 0;
  for (const OutputEstimate& file : estimate.files) {
    table.add(file.path, file.n_states, file.n_bytes);
    n_bytes += file.n_bytes;
  }
  if (estimate.files.size() > 1) table.add("in all", "", n_bytes);
  return text + table.format();
}

std::string format_estimated_time(const RunEstimate& estimate, int n_threads) {
  return fmt::format("  about {:.3g} s of the clock on {} {} besides writing files; {:.0f} MiB of memory\n",
                     estimate.seconds(), n_threads, n_threads == 1 ? "thread" : "threads", resident_memory());
}

}  // namespace contactsim

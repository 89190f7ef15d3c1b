// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace contactsim {

/// What `contactsim sweep` is asked for.
struct SweepOptions {
  bool is_asked = false;  ///< whether the command line says sweep
  std::string deck;
  std::optional<std::string> mesh;
  std::vector<std::string> definitions;  ///< of -D: ranges, lists and values
  std::string folder = "study";
  std::size_t n_jobs = 1;
  int n_threads = 0;  ///< of each run; 0: so many that all runs together fit the machine
  bool is_lenient = false;
  std::optional<std::string> points;     ///< CSV of points
  std::optional<std::size_t> n_samples;  ///< of a Latin hypercube
  std::uint64_t seed = 1;
  double max_runs = 1e4;
  std::optional<std::string> array;  ///< number of the one run to do, or "slurm"
  bool collects = false;             ///< only write study.csv and study.xml
  bool lists = false;                ///< only print the runs
};

/// Adds the subcommand `sweep`.
CLI::App* add_sweep(CLI::App& app, SweepOptions& options);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
// Times kernels of the program in turn with what the machine gives at best, so that both see the same
// machine.
//   contactsim_kernels [--rounds N] [--two-threads] [--operations] [--impact] [--slow NAME PERCENT] [NAME...]
// Without names: all kernels. Writes a line for each limit and kernel: its name, then pairs of a word and a
// number. Times are the least of the rounds, rates the greatest; of one thread they are those that it has
// computed, of two those on the wall. `--slow` makes a kernel take so much longer, which is what watching
// over it is tried with.
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "contact_scenes.hpp"
#include "kernel.hpp"
#include "machine_limits.hpp"
#include "operation_count.hpp"

namespace contactsim::bench {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct Options {
  int n_rounds = 5;
  bool two_threads = false, operations = false, impact = false;
  std::string slow_kernel;
  double slower = 0.0;  ///< [1]
  std::vector<std::string_view> names;
};

Options read_options(int n, char** words) {
  Options options;
  for (int i = 1; i < n; ++i) {
    const std::string_view word = words[i];
    if (word == "--rounds" && i + 1 < n) {
      options.n_rounds = std::atoi(words[++i]);
    } else if (word == "--two-threads") {
      options.two_threads = true;
    } else if (word == "--operations") {
      options.operations = true;
    } else if (word == "--impact") {
      options.impact = true;
    } else if (word == "--slow" && i + 2 < n) {
      options.slow_kernel = words[++i];
      options.slower = 0.01 * std::atof(words[++i]);
    } else {
      options.names.push_back(word);
    }
  }
  return options;
}

/// The greatest rates so far.
struct Limits {
  double triad[2] = {}, read[2] = {}, fused[2] = {}, unfused[2] = {};
  double division = 0.0, store = 0.0, load = 0.0, clock = 0.0;

  /// Those that kernels are watched by.
  void measure_references(StreamArrays& arrays) {
    take(triad[0], arrays.triad(1));
    take(unfused[0], unfused_rate(1));
  }
  void measure_rest(StreamArrays& arrays) {
    take(triad[1], arrays.triad(2));
    for (int i : {0, 1}) {
      take(read[i], arrays.read(i + 1));
      take(fused[i], fused_rate(i + 1));
    }
    take(unfused[1], unfused_rate(2));
    take(division, division_rate());
    take(store, store_rate());
    take(load, load_rate());
    take(clock, clock_rate());
  }
  void print() const {
    fmt::print("limits triad {:.4g} triad_2 {:.4g} read {:.4g} read_2 {:.4g} fused {:.4g} fused_2 {:.4g}",
               triad[0], triad[1], read[0], read[1], fused[0], fused[1]);
    fmt::print(" unfused {:.4g} unfused_2 {:.4g} division {:.4g} store {:.4g} load {:.4g} clock {:.4g}\n",
               unfused[0], unfused[1], division, store, load, clock);
  }

 private:
  static void take(double& greatest, double rate) { greatest = std::max(greatest, rate); }
};

/// The least times of steps: of each of some that differ, because something moves on between them.
class LeastTimes {
 public:
  void take(std::size_t step, double seconds) {
    if (steps_.size() <= step) steps_.resize(step + 1, std::numeric_limits<double>::infinity());
    steps_[step] = std::min(steps_[step], seconds);
  }
  double mean() const {
    if (steps_.empty()) return unknown;
    return std::accumulate(steps_.begin(), steps_.end(), 0.0) / static_cast<double>(steps_.size());
  }

 private:
  std::vector<double> steps_;
};

struct Timing {
  const KernelRow* row;
  Kernel kernel;
  double slower = 0.0;
  LeastTimes cpu = {}, wall = {}, wall_2 = {};
};

template <class Seconds>
double time_step(const Timing& timing, const Seconds& seconds) {
  const double begin = seconds();
  timing.kernel.step();
  const double end = begin + (seconds() - begin) * (1.0 + timing.slower);
  while (timing.slower > 0.0 && seconds() < end) {
  }
  return seconds() - begin;
}

/// Times steps by a clock: those from a fresh start on of what moves, else the same for some 60 ms, twice at
/// least.
template <class Seconds>
void time_steps(Timing& timing, const Seconds& seconds, LeastTimes& times) {
  constexpr double long_enough = 0.06;
  constexpr std::size_t n_first = 2, n_steps = 20;  // contact searches at the start and every 20
  if (timing.kernel.prepare) {
    timing.kernel = timing.row->make(timing.row->size);
    for (std::size_t i = 0; i < n_first + n_steps; ++i) {
      timing.kernel.prepare();
      const double step = time_step(timing, seconds);
      if (i >= n_first) times.take(i - n_first, step);
    }
    return;
  }
  double spent = 0.0;
  for (int n = 0; n < 2 || spent < long_enough; ++n) {
    const double step = time_step(timing, seconds);
    times.take(0, step);
    spent += step;
  }
}

void time_round(bool two_threads, Timing& timing) {
  omp_set_num_threads(1);
  time_steps(timing, thread_seconds, timing.cpu);
  if (!two_threads) return;
  time_steps(timing, wall_seconds, timing.wall);
  omp_set_num_threads(2);
  time_steps(timing, wall_seconds, timing.wall_2);
  omp_set_num_threads(1);
}

/// What a step of a small mesh executes.
void print_operations(const KernelRow& row) {
  const Kernel small = row.make(row.counted_size);
  const auto prepare = [&] {
    if (small.prepare) small.prepare();
  };
  for (int i = 0; i < 3; ++i) {  // contact searches twice at the start
    prepare();
    small.step();
  }
  prepare();
  const OperationCount count = count_operations(small.step);
  const auto per_item = [&](std::uint64_t number) { return static_cast<double>(number) / small.n_items; };
  fmt::print(" flops {:.5g} divisions {:.5g} instructions {:.5g} loaded {:.5g} stored {:.5g}",
             per_item(count.flops), per_item(count.divisions), per_item(count.instructions),
             per_item(count.loaded), per_item(count.stored));
}

void print(const Timing& timing, bool operations) {
  const double n = timing.kernel.n_items;
  fmt::print("{} item {} reference {} seconds {:.5g} bytes {:.5g}", timing.row->name, timing.row->item,
             timing.row->reference == Reference::flops ? "unfused" : "triad", timing.cpu.mean() / n,
             timing.kernel.n_bytes / n);
  fmt::print(" wall {:.5g} wall_2 {:.5g}", timing.wall.mean() / n, timing.wall_2.mean() / n);
  if (operations && timing.row->counted_size > 0) print_operations(*timing.row);
  fmt::print("\n");
  std::fflush(stdout);
}

/// The least share of contact in the rest of the step of two cubes in impact.
void print_impact(std::string_view name, PairSettings settings, int n_rounds) {
  double least = unknown;
  for (int round = 0; round < n_rounds; ++round) {
    constexpr int n_steps = 60;
    ImpactScene scene(settings);
    const double begin = wall_seconds();
    for (int i = 0; i < n_steps; ++i) scene.step();
    const double contact = scene.contact_seconds();
    least = std::fmin(least, contact / (wall_seconds() - begin - contact));
  }
  fmt::print("{} share {:.4g}\n", name, least);
}

std::vector<Timing> make_timings(const Options& options) {
  std::vector<Timing> timings;
  for (const auto rows : {element_kernels(), contact_kernels()}) {
    for (const KernelRow& row : rows) {
      const bool is_asked =
          std::find(options.names.begin(), options.names.end(), row.name) != options.names.end();
      if (!options.names.empty() && !is_asked) continue;
      const double slower = row.name == options.slow_kernel ? options.slower : 0.0;
      timings.push_back({&row, row.make(row.size), slower, {}, {}, {}});
    }
  }
  return timings;
}

void run(const Options& options) {
  omp_set_num_threads(1);
  StreamArrays arrays;
  Limits limits;
  std::vector<Timing> timings = make_timings(options);
  for (int round = 0; round < options.n_rounds; ++round) {
    if (options.two_threads) limits.measure_rest(arrays);
    for (Timing& timing : timings) {
      limits.measure_references(arrays);
      time_round(options.two_threads, timing);
    }
  }
  limits.print();
  for (const Timing& timing : timings) print(timing, options.operations);
  if (!options.impact) return;
  timings.clear();
  print_impact("impact_step", {ConstraintFormulation::face_face, Enforcement::momentum_balance},
               options.n_rounds);
  print_impact("impact_step_node_face", {ConstraintFormulation::node_face, Enforcement::momentum_balance},
               options.n_rounds);
}

}  // namespace

}  // namespace contactsim::bench

int main(int n, char** words) {
  contactsim::bench::run(contactsim::bench::read_options(n, words));
  return 0;
}

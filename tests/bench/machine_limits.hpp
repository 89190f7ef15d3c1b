// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>

/// What the machine gives at best, to set beside what kernels reach in the same run. Every function takes a
/// short time, some 10 ms, and is meant to be called again and again between what it is compared with.
namespace contactsim::bench {

/// Arrays of 200 MB each, far larger than any cache, laid down by two threads.
class StreamArrays {
 public:
  StreamArrays();

  /// a = b + s c. Source: McCalpin, STREAM (1995).
  ///   returns  24 bytes per entry over the time [bytes/s]
  double triad(int n_threads);
  /// The sum of an array: 8 bytes per entry [bytes/s].
  double read(int n_threads);

  static constexpr std::size_t n = 25'000'000;

 private:
  std::unique_ptr<double[]> a_, b_, c_;
};

/// Multiply-adds on vectors of eight doubles, two operations each [1/s].
double fused_rate(int n_threads);
/// The same with multiplication and addition apart, as the program is compiled.
double unfused_rate(int n_threads);

/// Divisions of vectors of eight doubles, one thread [doubles/s].
double division_rate();

/// Copies of vectors of eight doubles within the first cache, one thread: as many bytes loaded as stored.
///   returns  bytes stored [bytes/s]
double store_rate();
/// Sums of vectors of eight doubles in the first cache, one thread.
///   returns  bytes loaded [bytes/s]
double load_rate();

/// Clock of the processor, by a chain of additions [1/s].
double clock_rate();

/// Seconds that the calling thread has computed: what others do meanwhile on the machine is not counted.
double thread_seconds();
/// Seconds on the wall.
double wall_seconds();

}  // namespace contactsim::bench

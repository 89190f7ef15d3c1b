// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <omp.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace contactsim {

/// How many of OpenMP's threads are worth waking for n small items of work: waking one costs as much as some
/// ten thousand of them. Results never depend on it.
inline int threads_for(std::size_t n) {
  constexpr std::size_t items_per_thread = 10000;
  return static_cast<int>(
      std::clamp<std::size_t>(n / items_per_thread, 1, static_cast<std::size_t>(omp_get_max_threads())));
}

// OpenMP makes, wakes and joins even a team of one by system calls, a tenth of a small run's step. One thread
// therefore goes by a plain loop.

/// Calls function(i) for every i below n, in equal shares of the threads.
///   n_threads  of threads_for()
template <class Size, class Function>
void parallel_for(Size n, int n_threads, const Function& function) {
  if (n_threads == 1) {
    for (Size i = 0; i < n; ++i) function(i);
    return;
  }
#pragma omp parallel for schedule(static) num_threads(n_threads)
  for (Size i = 0; i < n; ++i) function(i);
}

/// The same of items that take unequal times: each thread takes the next one when it is done.
template <class Size, class Function>
void parallel_for_uneven(Size n, int n_threads, const Function& function) {
  if (n_threads == 1) {
    for (Size i = 0; i < n; ++i) function(i);
    return;
  }
#pragma omp parallel for schedule(dynamic) num_threads(n_threads)
  for (Size i = 0; i < n; ++i) function(i);
}

/// Calls function(begin, end) for the shares of the threads in the items below n, for loops over plain
/// arrays.
template <class Function>
void parallel_for_ranges(std::int64_t n, int n_threads, const Function& function) {
  parallel_for(n_threads, n_threads, [&](int i) { function(n * i / n_threads, n * (i + 1) / n_threads); });
}

/// The least of start and function(i) for every i below n.
template <class Size, class Value, class Function>
Value parallel_min(Size n, int n_threads, Value start, const Function& function) {
  Value least = start;
  if (n_threads == 1) {
    for (Size i = 0; i < n; ++i) least = std::min(least, function(i));
    return least;
  }
#pragma omp parallel for schedule(static) num_threads(n_threads) reduction(min : least)
  for (Size i = 0; i < n; ++i) least = std::min(least, function(i));
  return least;
}

/// The largest of start and function(i) for every i below n.
template <class Size, class Value, class Function>
Value parallel_max(Size n, int n_threads, Value start, const Function& function) {
  return -parallel_min(n, n_threads, -start, [&](Size i) { return -function(i); });
}

}  // namespace contactsim

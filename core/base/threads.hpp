// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <omp.h>

#include <algorithm>
#include <cstddef>

namespace contactsim {

/// How many of OpenMP's threads are worth waking for n small items of work: waking one costs as much as some
/// ten thousand of them. Results never depend on it.
inline int threads_for(std::size_t n) {
  constexpr std::size_t items_per_thread = 10000;
  return static_cast<int>(
      std::clamp<std::size_t>(n / items_per_thread, 1, static_cast<std::size_t>(omp_get_max_threads())));
}

}  // namespace contactsim

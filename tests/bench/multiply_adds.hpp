// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

/// Loops that a compiler can make no shorter, over the vectors that kernels work with. Each stands in a
/// source of its own because flags decide whether x * m + a is one operation or two.
namespace contactsim::bench {

using Eight [[gnu::vector_size(8 * sizeof(double))]] = double;

/// Independent chains that hide the latency of each other's operations.
inline constexpr std::size_t n_chains = 12;

/// Does n_rounds x n_chains multiply-adds on Eight. Returns a number that depends on all of them.
template <class = void>
[[gnu::always_inline]] inline double run_multiply_adds(std::size_t n_rounds) {
  Eight x[n_chains], m, a;
  for (std::size_t lane = 0; lane < 8; ++lane) {
    m[lane] = 1.0 - 1e-9 * static_cast<double>(lane);
    a[lane] = 1e-9;
  }
  for (std::size_t i = 0; i < n_chains; ++i) x[i] = a * static_cast<double>(i);
  for (std::size_t round = 0; round < n_rounds; ++round) {
#pragma GCC unroll 12
    for (std::size_t i = 0; i < n_chains; ++i) x[i] = x[i] * m + a;
  }
  Eight sum = x[0];
  for (std::size_t i = 1; i < n_chains; ++i) sum += x[i];
  return sum[0] + sum[7];
}

double multiply_adds_unfused(std::size_t n_rounds);
double multiply_adds_fused(std::size_t n_rounds);

}  // namespace contactsim::bench

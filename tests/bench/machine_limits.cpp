// SPDX-License-Identifier: BSD-3-Clause
#include "machine_limits.hpp"

#include <benchmark/benchmark.h>
#include <omp.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <ctime>

#include "multiply_adds.hpp"

namespace contactsim::bench {

namespace {

/// The time of a thread that is alone, of the wall otherwise.
double seconds(int n_threads) { return n_threads == 1 ? thread_seconds() : wall_seconds(); }

template <class Work>
double rate(double amount, int n_threads, const Work& work) {
  const double begin = seconds(n_threads);
  work();
  return amount / (seconds(n_threads) - begin);
}

template <class Work>
double rate_on_threads(double amount, int n_threads, const Work& work) {
  return rate(amount * n_threads, n_threads, [&] {
#pragma omp parallel num_threads(n_threads)
    benchmark::DoNotOptimize(work());
  });
}

constexpr std::size_t n_rounds = 1'000'000;
constexpr double n_operations = 2.0 * 8.0 * n_chains * n_rounds;

}  // namespace

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

StreamArrays::StreamArrays() : a_(new double[n]), b_(new double[n]), c_(new double[n]) {
#pragma omp parallel for schedule(static) num_threads(2)
  for (std::size_t i = 0; i < n; ++i) {
    a_[i] = 0.0;
    b_[i] = 1.0;
    c_[i] = 2.0;
  }
}

double StreamArrays::triad(int n_threads) {
  double *a = a_.get(), *b = b_.get(), *c = c_.get();
  return rate(24.0 * n, n_threads, [=] {
#pragma omp parallel for simd schedule(static) num_threads(n_threads)
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 3.0 * c[i];
    benchmark::ClobberMemory();
  });
}

double StreamArrays::read(int n_threads) {
  const double* b = b_.get();
  return rate(8.0 * n, n_threads, [=] {
    double sum = 0.0;
#pragma omp parallel num_threads(n_threads) reduction(+ : sum)
    {
      constexpr std::size_t n_at_once = 4, group = 8 * n_at_once;
      std::array<Eight, n_at_once> parts{};
#pragma omp for schedule(static)
      for (std::size_t i = 0; i < n / group; ++i) {
        for (std::size_t k = 0; k < n_at_once; ++k) {
          Eight values;
          std::memcpy(&values, b + i * group + 8 * k, sizeof values);
          parts[k] += values;
        }
      }
      for (const Eight& part : parts) sum += part[0];
    }
    benchmark::DoNotOptimize(sum);
  });
}

double fused_rate(int n_threads) {
  return rate_on_threads(n_operations, n_threads, [] { return multiply_adds_fused(n_rounds); });
}

double unfused_rate(int n_threads) {
  return rate_on_threads(n_operations, n_threads, [] { return multiply_adds_unfused(n_rounds); });
}

double division_rate() {
  constexpr std::size_t n_steps = 100'000;
  std::array<Eight, 8> x;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = Eight{} + (1.5 + static_cast<double>(i));
  return rate(64.0 * n_steps, 1, [&] {
    for (std::size_t step = 0; step < n_steps; ++step) {
      for (Eight& chain : x) chain = 3.0 / chain;
    }
    benchmark::DoNotOptimize(x);
  });
}

double store_rate() {
  constexpr std::size_t n_vectors = 128, n_copies = 20'000;
  std::array<Eight, n_vectors> from{}, to{};
  return rate(64.0 * n_vectors * n_copies, 1, [&] {
    for (std::size_t copy = 0; copy < n_copies; ++copy) {
#pragma GCC unroll 8
      for (std::size_t i = 0; i < n_vectors; ++i) to[i] = from[i];
      benchmark::ClobberMemory();
      benchmark::DoNotOptimize(to);
    }
  });
}

double load_rate() {
  constexpr std::size_t n_vectors = 128, n_passes = 40'000;
  std::array<Eight, n_vectors> from{};
  return rate(64.0 * n_vectors * n_passes, 1, [&] {
    Eight a{}, b{}, c{}, d{}, e{}, f{}, g{}, h{};  // an array would lie in the cache itself
    for (std::size_t pass = 0; pass < n_passes; ++pass) {
      for (const Eight* next = from.data(); next != from.data() + n_vectors; next += 8) {
        a += next[0];
        b += next[1];
        c += next[2];
        d += next[3];
        e += next[4];
        f += next[5];
        g += next[6];
        h += next[7];
      }
      benchmark::DoNotOptimize(from);
    }
    benchmark::DoNotOptimize(a + b + c + d + e + f + g + h);
  });
}

double clock_rate() {
  constexpr std::size_t n_additions = 10'000'000;
  return rate(n_additions, 1, [] {
    std::uint64_t x = 1;
    for (std::size_t i = 0; i < n_additions / 10; ++i) {
#pragma GCC unroll 10
      for (int k = 0; k < 10; ++k) {
        x += i;
        asm volatile("" : "+r"(x));
      }
    }
    benchmark::DoNotOptimize(x);
  });
}

}  // namespace contactsim::bench

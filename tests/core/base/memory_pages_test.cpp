// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/memory_pages.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Memory of this process that is its own [bytes].
double own_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != "RssAnon:") continue;
    double kilobytes = 0.0;
    status >> kilobytes;
    return 1024.0 * kilobytes;
  }
  return 0.0;
}

}  // namespace

TEST_CASE("numbers are zero wherever they begin and end, and those beside them stay",
          "[core][memory_pages]") {
  const std::size_t n = GENERATE(0u, 1u, 511u, 512u, 513u, 1024u, 5000u, 100000u);
  const std::size_t first = GENERATE(0u, 1u, 300u, 512u);
  std::vector<double> values(n + first + 700, 3.0);
  set_zero_without_memory(std::span(values).subspan(first, n));
  CHECK(std::count(values.begin(), values.end(), 3.0) == static_cast<std::ptrdiff_t>(first + 700));
  CHECK(std::count(values.begin(), values.end(), 0.0) == static_cast<std::ptrdiff_t>(n));
  CHECK(values[first + n] == 3.0);
  if (n == 0) return;
  CHECK(values[first] == 0.0);
  std::fill(values.begin(), values.end(), 4.0);
  CHECK(values[first + n / 2] == 4.0);
}

TEST_CASE("what stays zero takes no memory, read or not", "[core][memory_pages]") {
  constexpr std::size_t n = 8'000'000;
  std::vector<double> values(n, 1.0);
  const double before = own_memory();
  REQUIRE(before > sizeof(double) * n);
  set_zero_without_memory(values);
  double sum = 0.0;
  for (const double value : values) sum += value;
  CHECK(sum == 0.0);
  CHECK(own_memory() < before - 0.9 * sizeof(double) * n);
  std::fill_n(values.begin(), n / 2, 2.0);
  CHECK(own_memory() > before - 0.6 * sizeof(double) * n);
}

TEST_CASE("what many small arrays have freed goes back to the system", "[core][memory_pages]") {
  std::vector<std::vector<double>> arrays(20'000, std::vector<double>(200, 1.0));
  const std::vector<double> behind_them(200, 1.0);  // so that they are not at the end of the heap
  const double before = own_memory();
  arrays.clear();
  return_freed_memory();
  CHECK(own_memory() < before - 0.8 * 20'000 * 200 * sizeof(double));
  CHECK(behind_them.back() == 1.0);
}

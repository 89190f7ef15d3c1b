// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/memory_pages.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
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

/// What Linux says of the memory at an address, "" where it says nothing.
std::string flags_of_memory(const void* address) {
  const auto wanted = reinterpret_cast<std::uintptr_t>(address);
  std::ifstream maps("/proc/self/smaps");
  bool is_there = false;
  for (std::string line; std::getline(maps, line);) {
    std::uintptr_t begin = 0, end = 0;
    if (std::sscanf(line.c_str(), "%lx-%lx ", &begin, &end) == 2) is_there = begin <= wanted && wanted < end;
    if (is_there && line.starts_with("VmFlags:")) return line + " ";
  }
  return "";
}

}  // namespace

TEST_CASE("an array is asked for in huge pages", "[core][memory_pages]") {
  std::vector<double> values{1.0};
  assign_in_huge_pages(4'000'000, 2.0, values);
  CHECK(std::count(values.begin(), values.end(), 2.0) == 4'000'000);
  std::vector<double> none{1.0};
  assign_in_huge_pages(0, 2.0, none);
  CHECK(none.empty());
  const bool has_huge_pages = std::filesystem::exists("/sys/kernel/mm/transparent_hugepage");
  const std::string flags = flags_of_memory(&values[2'000'000]);
  if (has_huge_pages && !flags.empty()) CHECK(flags.find(" hg ") != std::string::npos);
}

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

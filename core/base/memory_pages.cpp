// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/memory_pages.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>

namespace contactsim {

namespace {

double* at_address(std::uintptr_t address) { return reinterpret_cast<double*>(address); }

}  // namespace

void set_zero_without_memory(std::span<double> values) {
  double *const begin = values.data(), *const end = begin + values.size();
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  double* const first = at_address((reinterpret_cast<std::uintptr_t>(begin) + page - 1) / page * page);
  double* const last = at_address(reinterpret_cast<std::uintptr_t>(end) / page * page);
  // Linux gives private memory back as zeros; it refuses for locked pages, among others.
  const bool is_given_back =
      first < last &&
      madvise(first, static_cast<std::size_t>(last - first) * sizeof(double), MADV_DONTNEED) == 0;
  std::fill(begin, is_given_back ? first : end, 0.0);
  if (is_given_back) std::fill(last, end, 0.0);
}

void return_freed_memory() { malloc_trim(0); }

}  // namespace contactsim

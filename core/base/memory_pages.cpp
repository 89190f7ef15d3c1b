// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/memory_pages.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>

namespace contactsim {

namespace {

/// The pages that lie in some memory as a whole.
std::span<std::byte> whole_pages(std::span<std::byte> bytes) {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t before = (page - reinterpret_cast<std::uintptr_t>(bytes.data()) % page) % page;
  if (bytes.size() < before) return {};
  return bytes.subspan(before, (bytes.size() - before) / page * page);
}

}  // namespace

void set_zero_without_memory(std::span<double> values) {
  const std::span<std::byte> all = std::as_writable_bytes(values), pages = whole_pages(all);
  // Linux gives private memory back as zeros; it refuses for locked pages, among others.
  if (pages.empty() || madvise(pages.data(), pages.size(), MADV_DONTNEED) != 0) {
    std::ranges::fill(values, 0.0);
    return;
  }
  const std::size_t begin = static_cast<std::size_t>(pages.data() - all.data()) / sizeof(double);
  std::ranges::fill(values.first(begin), 0.0);
  std::ranges::fill(values.subspan(begin + pages.size() / sizeof(double)), 0.0);
}

void prefer_huge_pages(std::span<std::byte> bytes) {
  const std::span<std::byte> pages = whole_pages(bytes);
  if (!pages.empty()) madvise(pages.data(), pages.size(), MADV_HUGEPAGE);
}

void return_freed_memory() { malloc_trim(0); }

}  // namespace contactsim

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
class Pages {
 public:
  explicit Pages(std::span<const std::byte> bytes) {
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const auto first = reinterpret_cast<std::uintptr_t>(bytes.data());
    begin_ = (first + page - 1) / page * page;
    end_ = std::max(begin_, (first + bytes.size()) / page * page);
  }
  void* begin() const { return reinterpret_cast<void*>(begin_); }
  void* end() const { return reinterpret_cast<void*>(end_); }
  std::size_t size() const { return end_ - begin_; }

 private:
  std::uintptr_t begin_ = 0, end_ = 0;
};

}  // namespace

void set_zero_without_memory(std::span<double> values) {
  const Pages pages(std::as_bytes(values));
  double *const begin = values.data(), *const end = begin + values.size();
  // Linux gives private memory back as zeros; it refuses for locked pages, among others.
  const bool is_given_back = pages.size() > 0 && madvise(pages.begin(), pages.size(), MADV_DONTNEED) == 0;
  std::fill(begin, is_given_back ? static_cast<double*>(pages.begin()) : end, 0.0);
  if (is_given_back) std::fill(static_cast<double*>(pages.end()), end, 0.0);
}

void prefer_huge_pages(std::span<const std::byte> bytes) {
  const Pages pages(bytes);
  if (pages.size() > 0) madvise(pages.begin(), pages.size(), MADV_HUGEPAGE);
}

void return_freed_memory() { malloc_trim(0); }

}  // namespace contactsim

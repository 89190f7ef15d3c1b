// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/pair_lists.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "core/base/state_archive.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

namespace {

/// Rows first to end - 1, which one thread works on alone.
struct RowRange {
  std::uint32_t first, end;

  bool holds(std::uint32_t row) const { return row - first < end - first; }
};

RowRange share(std::uint64_t n_rows, int i, int n) {
  return {static_cast<std::uint32_t>(n_rows * i / n), static_cast<std::uint32_t>(n_rows * (i + 1) / n)};
}

/// Counts the pairs of each row, into the place after it.
void count_pairs(std::span<const FoundPairs> parts, RowRange rows, std::vector<std::uint32_t>& begin) {
  for (const FoundPairs& part : parts) {
    for (const RowPartner& pair : part.pairs) {
      if (rows.holds(pair.row)) ++begin[pair.row + 1];
    }
  }
}

/// Puts the partners of each row together. The place after a row holds where its next partner goes, in the
/// end where those of the next row begin.
void place_pairs(std::span<const FoundPairs> parts, RowRange rows, PairTable& lists) {
  for (const FoundPairs& part : parts) {
    for (const RowPartner& pair : part.pairs) {
      if (rows.holds(pair.row)) lists.partners[lists.begin[pair.row + 1]++] = pair.partner;
    }
  }
}

void sort_rows(RowRange rows, PairTable& lists) {
  const auto partners = lists.partners.begin();
  for (std::uint32_t row = rows.first; row < rows.end; ++row) {
    std::sort(partners + static_cast<std::ptrdiff_t>(lists.begin[row]),
              partners + static_cast<std::ptrdiff_t>(lists.begin[row + 1]));
  }
}

/// Turns the counts after each row into the number of pairs before it.
void sum_counts(std::vector<std::uint32_t>& begin) {
  std::uint32_t n_before = 0;
  for (std::size_t i = 1; i < begin.size(); ++i) {
    const std::uint32_t n = begin[i];
    begin[i] = n_before;
    n_before += n;
  }
}

}  // namespace

void list_pairs(std::span<const FoundPairs> parts, std::uint32_t n_rows, PairTable& lists) {
  std::size_t n_pairs = 0;
  for (const FoundPairs& part : parts) n_pairs += part.pairs.size();
  if (n_pairs > std::numeric_limits<std::uint32_t>::max())
    throw std::length_error("more than 4 billion candidates of contact");
  lists.begin.assign(std::size_t{n_rows} + 1, 0);
  // Growing in place would take room for twice as many.
  if (lists.partners.capacity() < n_pairs) lists.partners = {};
  lists.partners.resize(n_pairs);
  const int n = threads_for(n_pairs);
#pragma omp parallel for schedule(static, 1) num_threads(n)
  for (int i = 0; i < n; ++i) count_pairs(parts, share(n_rows, i, n), lists.begin);
  sum_counts(lists.begin);
#pragma omp parallel for schedule(static, 1) num_threads(n)
  for (int i = 0; i < n; ++i) place_pairs(parts, share(n_rows, i, n), lists);
#pragma omp parallel for schedule(static, 1) num_threads(n)
  for (int i = 0; i < n; ++i) sort_rows(share(n_rows, i, n), lists);
}

void archive(const std::string& name, PairTable& lists, StateArchive& saved) {
  saved.list(name + "/begin", lists.begin);
  saved.list(name + "/partners", lists.partners);
}

}  // namespace contactsim

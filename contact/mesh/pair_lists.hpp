// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "core/base/bytes_of.hpp"
#include "core/base/index.hpp"

namespace contactsim {

class StateArchive;

/// Pairs of numbers row by row: those of row i are partners[begin[i]] to partners[begin[i + 1] - 1],
/// ascending.
struct PairTable {
  std::vector<std::uint32_t> begin = {0};  ///< [n_rows + 1]
  std::vector<std::uint32_t> partners;     ///< [n_pairs]

  std::size_t n_rows() const { return begin.size() - 1; }
  std::size_t bytes() const { return bytes_of(begin) + bytes_of(partners); }
  /// The partners of one row, ascending.
  std::span<const std::uint32_t> of(std::size_t row) const {
    return std::span(partners).subspan(begin[row], begin[row + 1] - begin[row]);
  }
};

/// Numbers seen as positions.
template <class AnIndex>
class IndexView {
 public:
  class Iterator {
   public:
    using value_type = AnIndex;
    using difference_type = std::ptrdiff_t;
    using iterator_concept = std::forward_iterator_tag;
    using iterator_category = std::input_iterator_tag;
    constexpr Iterator() = default;
    constexpr explicit Iterator(const std::uint32_t* number) : number_(number) {}
    constexpr AnIndex operator*() const { return {*number_}; }
    constexpr Iterator& operator++() {
      ++number_;
      return *this;
    }
    constexpr Iterator operator++(int) { return Iterator(number_++); }
    constexpr bool operator==(const Iterator&) const = default;

   private:
    const std::uint32_t* number_ = nullptr;
  };

  constexpr IndexView() = default;
  constexpr explicit IndexView(std::span<const std::uint32_t> numbers) : numbers_(numbers) {}
  constexpr Iterator begin() const { return Iterator(numbers_.data()); }
  constexpr Iterator end() const { return Iterator(numbers_.data() + numbers_.size()); }
  constexpr std::size_t size() const { return numbers_.size(); }
  constexpr bool empty() const { return numbers_.empty(); }
  constexpr AnIndex front() const { return {numbers_.front()}; }
  constexpr AnIndex operator[](std::size_t i) const { return {numbers_[i]}; }

 private:
  std::span<const std::uint32_t> numbers_;
};

/// Pairs of positions row by row.
template <class Row, class Partner>
struct PairLists : PairTable {
  IndexRange<Row> rows() const { return {{}, {static_cast<std::uint32_t>(n_rows())}}; }
  /// The partners of one row, ascending.
  IndexView<Partner> of(Row row) const { return IndexView<Partner>(PairTable::of(number_of(row))); }
  /// Pairs are counted through; those of a row, and the partner of one.
  std::size_t first_pair(Row row) const { return begin[number_of(row)]; }
  std::size_t end_pair(Row row) const { return begin[number_of(row) + 1]; }
  Partner partner(std::size_t pair) const { return {partners[pair]}; }
  /// Which pair of the lists these are.
  std::size_t position(Row row, Partner partner) const {
    const auto of_row = PairTable::of(number_of(row));
    return first_pair(row) +
           static_cast<std::size_t>(std::ranges::lower_bound(of_row, number_of(partner)) - of_row.begin());
  }
};

/// Saves or restores lists.
void archive(const std::string& name, PairTable& lists, StateArchive& saved);

/// Two boxes that may meet.
struct RowPartner {
  std::uint32_t row, partner;
};

/// Pairs in the order in which one part of a search met them.
struct FoundPairs {
  std::vector<RowPartner> pairs;
  std::uint64_t visits = 0;    ///< pairs of nodes looked at
  std::uint64_t overlaps = 0;  ///< pairs of boxes that overlapped, kept or not
};

/// Sorts what the parts of a search have found, each pair once, into lists; their order and that of the pairs
/// does not matter. Runs on OpenMP's threads.
///   n_rows  above every row
///   lists   overwritten, its memory reused
/// Throws std::length_error from 2^32 pairs on.
void list_pairs(std::span<const FoundPairs> parts, std::uint32_t n_rows, PairTable& lists);

/// Lists partners by rows.
///   visit(take)  calls take(row, partner) for every entry, in the same order each time
template <class Row, class Partner, class Visit>
PairLists<Row, Partner> list_by_row(std::size_t n_rows, const Visit& visit) {
  PairLists<Row, Partner> lists;
  lists.begin.assign(n_rows + 1, 0);
  visit([&](Row row, Partner) { ++lists.begin[number_of(row) + 1]; });
  for (std::size_t i = 0; i < n_rows; ++i) lists.begin[i + 1] += lists.begin[i];
  lists.partners.resize(lists.begin.back());
  std::vector<std::uint32_t> next(lists.begin.begin(), lists.begin.end() - 1);
  visit([&](Row row, Partner partner) { lists.partners[next[number_of(row)]++] = number_of(partner); });
  return lists;
}

/// What is known of the pairs of some lists, for other lists: that of the pairs in both, else a value.
///   known  [n_pairs of `old`]
template <class Value>
std::vector<Value> transfer_pairs(const PairTable& old, std::span<const Value> known, const PairTable& lists,
                                  const Value& otherwise) {
  std::vector<Value> transferred(lists.partners.size(), otherwise);
  const std::size_t n_rows = std::min(old.n_rows(), lists.n_rows());
  for (std::size_t row = 0; row < n_rows; ++row) {
    std::size_t from = old.begin[row];
    for (std::size_t k = lists.begin[row]; k < lists.begin[row + 1]; ++k) {
      while (from < old.begin[row + 1] && old.partners[from] < lists.partners[k]) ++from;
      if (from < old.begin[row + 1] && old.partners[from] == lists.partners[k]) transferred[k] = known[from];
    }
  }
  return transferred;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/optional_index.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

/// A row that pushes a carrier.
struct RowPush {
  double weight = 0.0;  ///< of the carrier in the row [1]
  std::uint32_t row = 0;
  OptionalIndex<std::uint32_t> arm;  ///< of a carrier that turns
};

/// What pushes each carrier, in its order: B^T by its rows, where B has one row per constraint. Carriers that
/// take their pushes from here sum up on all threads at once, each with the bits that the pushes one after
/// the other give.
template <class Push>
class PushLists {
 public:
  /// Makes the lists anew, by a counting sort of all threads: alike for any number of them.
  ///   n_items    in which the pushes come
  ///   visit      visit(begin, end, take) calls take(carrier, push) for all pushes of these items, one after
  ///              the other, alike each time
  template <class Visit>
  void make(std::size_t n_carriers, std::size_t n_items, int n_threads, const Visit& visit);

  std::size_t n_carriers() const { return begin_.size() - 1; }
  std::span<const Push> of(std::size_t carrier) const {
    return std::span(pushes_).subspan(begin_[carrier], begin_[carrier + 1] - begin_[carrier]);
  }

 private:
  std::vector<std::uint32_t> begin_{0};  // [n_carriers + 1] in pushes_
  std::vector<std::uint32_t> places_;    // [n_threads][n_carriers] counts, then where a thread's pushes go
  std::vector<Push> pushes_;             // carrier by carrier
};

template <class Push>
template <class Visit>
void PushLists<Push>::make(std::size_t n_carriers, std::size_t n_items, int n_threads, const Visit& visit) {
  const auto n_parts = static_cast<std::size_t>(n_threads);
  const auto of_part = [&](std::size_t part) {
    return places_.begin() + static_cast<std::ptrdiff_t>(part * n_carriers);
  };
  const auto visit_part = [&](std::size_t part, const auto& take) {
    visit(n_items * part / n_parts, n_items * (part + 1) / n_parts, take);
  };
  begin_.resize(n_carriers + 1);
  places_.resize(n_parts * n_carriers);
  parallel_for(n_parts, n_threads, [&](std::size_t part) {
    const auto counts = of_part(part);
    std::fill_n(counts, n_carriers, 0);
    visit_part(part, [&](std::uint32_t carrier, const Push&) { ++counts[carrier]; });
  });
  std::uint32_t n_pushes = 0;
  for (std::size_t carrier = 0; carrier < n_carriers; ++carrier) {
    begin_[carrier] = n_pushes;
    for (std::size_t part = 0; part < n_parts; ++part)
      n_pushes += std::exchange(places_[part * n_carriers + carrier], n_pushes);
  }
  begin_[n_carriers] = n_pushes;
  pushes_.resize(n_pushes);
  parallel_for(n_parts, n_threads, [&](std::size_t part) {
    const auto places = of_part(part);
    visit_part(part, [&](std::uint32_t carrier, const Push& push) { pushes_[places[carrier]++] = push; });
  });
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/optional_index.hpp"

namespace contactsim {

/// The rows that push each carrier, in their order: B^T by its rows, where B has one row per constraint.
/// Carriers that take their pushes from here sum up on all threads at once, each with the bits that the rows
/// one after the other give.
class PushLists {
 public:
  struct Push {
    double weight = 0.0;  ///< of the carrier in the row [1]
    std::uint32_t row = 0;
    OptionalIndex<std::uint32_t> arm;  ///< of a carrier that turns
  };

  /// Makes the lists anew.
  ///   visit  visit(take) calls take(carrier, push) for all pushes, rows ascending, alike each time
  template <class Visit>
  void make(std::size_t n_carriers, const Visit& visit) {
    begin_.assign(n_carriers + 1, 0);
    visit([this](std::uint32_t carrier, const Push&) { ++begin_[carrier + 1]; });
    for (std::size_t i = 0; i < n_carriers; ++i) begin_[i + 1] += begin_[i];
    pushes_.resize(begin_.back());
    next_.assign(begin_.begin(), begin_.end() - 1);
    visit([this](std::uint32_t carrier, const Push& push) { pushes_[next_[carrier]++] = push; });
  }

  std::size_t n_carriers() const { return next_.size(); }
  std::span<const Push> of(std::size_t carrier) const {
    return std::span(pushes_).subspan(begin_[carrier], begin_[carrier + 1] - begin_[carrier]);
  }

 private:
  std::vector<std::uint32_t> begin_, next_;  // [n_carriers + 1], [n_carriers] in pushes_
  std::vector<Push> pushes_;                 // carrier by carrier
};

}  // namespace contactsim

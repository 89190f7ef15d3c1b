// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/id_lookup.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace contactsim {

namespace {

// A table wins over sorting as long as it stays in the size of the ids themselves.
constexpr std::uint64_t widest_table(std::size_t n_ids) { return 2 * static_cast<std::uint64_t>(n_ids) + 64; }

}  // namespace

IdLookup::IdLookup(std::span<const std::int64_t> ids) {
  const bool increase = std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) == ids.end();
  if (increase) return;
  const auto [smallest, largest] = std::minmax_element(ids.begin(), ids.end());
  smallest_ = *smallest;
  const std::uint64_t range = static_cast<std::uint64_t>(*largest) - static_cast<std::uint64_t>(*smallest);
  if (range < widest_table(ids.size())) {
    fill_table(ids, *largest);
  } else {
    sort_order(ids);
  }
}

void IdLookup::fill_table(std::span<const std::int64_t> ids, std::int64_t largest) {
  table_.assign(static_cast<std::size_t>(largest - smallest_) + 1, std::nullopt);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    OptionalIndex<std::uint32_t>& position = table_[static_cast<std::size_t>(ids[i] - smallest_)];
    if (!position) {
      position = static_cast<std::uint32_t>(i);
    } else if (!first_repeat_) {
      first_repeat_ = static_cast<std::uint32_t>(i);
    }
  }
}

void IdLookup::sort_order(std::span<const std::int64_t> ids) {
  order_.resize(ids.size());
  std::iota(order_.begin(), order_.end(), 0u);
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return ids[a] < ids[b]; });
  for (std::size_t i = 1; i < order_.size(); ++i) {
    if (ids[order_[i]] != ids[order_[i - 1]]) continue;
    first_repeat_ = std::min(order_[i], first_repeat_.value_or(order_[i]));
  }
}

std::optional<std::uint32_t> IdLookup::find(std::span<const std::int64_t> ids, std::int64_t id) const {
  if (!table_.empty()) {
    const std::uint64_t slot = static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(smallest_);
    if (id < smallest_ || slot >= table_.size() || !table_[slot]) return std::nullopt;
    return *table_[slot];
  }
  if (!order_.empty()) {
    const auto found =
        std::lower_bound(order_.begin(), order_.end(), id,
                         [&](std::uint32_t position, std::int64_t x) { return ids[position] < x; });
    if (found == order_.end() || ids[*found] != id) return std::nullopt;
    return *found;
  }
  const auto found = std::lower_bound(ids.begin(), ids.end(), id);
  if (found == ids.end() || *found != id) return std::nullopt;
  return static_cast<std::uint32_t>(found - ids.begin());
}

}  // namespace contactsim

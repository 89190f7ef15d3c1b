// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/optional_index.hpp"

namespace contactsim {

/// Finds the position of a user id. Costs no memory when the ids increase, as those of most files do; else a
/// table over their range when that is narrow, else a sorted order.
class IdLookup {
 public:
  IdLookup() = default;
  /// ids  [n]  user ids by position; repeats are allowed, the first one is found
  explicit IdLookup(std::span<const std::int64_t> ids);

  /// Position of the id, if there is one. The ids are those given to the constructor.
  std::optional<std::uint32_t> find(std::span<const std::int64_t> ids, std::int64_t id) const;

  /// Position of the first id in position order that stood before, if any.
  std::optional<std::uint32_t> first_repeat() const { return first_repeat_; }

 private:
  void fill_table(std::span<const std::int64_t> ids, std::int64_t largest);
  void sort_order(std::span<const std::int64_t> ids);

  std::int64_t smallest_ = 0;                        ///< id of table_[0]
  std::vector<OptionalIndex<std::uint32_t>> table_;  ///< position by id - smallest_
  std::vector<std::uint32_t> order_;                 ///< positions by increasing id
  std::optional<std::uint32_t> first_repeat_;
};

}  // namespace contactsim

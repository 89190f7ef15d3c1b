// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cassert>
#include <cstdint>
#include <optional>

namespace contactsim {

/// A position that may be absent, as large as one that may not: std::optional would make arrays of positions
/// twice as large. Asked as std::optional is.
class OptionalIndex {
 public:
  using Scalar = std::uint32_t;  ///< that archives save; absent is the largest

  constexpr OptionalIndex() = default;
  constexpr OptionalIndex(std::nullopt_t) {}
  constexpr OptionalIndex(std::uint32_t index) : index_(index) { assert(index != absent); }

  constexpr bool has_value() const { return index_ != absent; }
  constexpr explicit operator bool() const { return has_value(); }
  /// The position; there must be one.
  constexpr std::uint32_t operator*() const {
    assert(has_value());
    return index_;
  }
  constexpr bool operator==(const OptionalIndex&) const = default;

 private:
  static constexpr std::uint32_t absent = 0xffffffff;
  std::uint32_t index_ = absent;
};

static_assert(sizeof(OptionalIndex) == sizeof(std::uint32_t));

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cassert>
#include <cstdint>
#include <optional>

#include "core/base/index.hpp"

namespace contactsim {

/// A position that may be absent, as large as one that may not: std::optional would make arrays of positions
/// twice as large. Asked as std::optional is.
///   AnIndex  an Index, or std::uint32_t for a position in a list of whoever has it
template <class AnIndex>
class OptionalIndex {
 public:
  using Scalar = std::uint32_t;  ///< that archives save; absent is the largest

  constexpr OptionalIndex() = default;
  constexpr OptionalIndex(std::nullopt_t) {}
  constexpr OptionalIndex(AnIndex index) : index_(index) { assert(has_value()); }

  constexpr bool has_value() const { return index_ != absent; }
  constexpr explicit operator bool() const { return has_value(); }
  /// The position; there must be one.
  constexpr AnIndex operator*() const {
    assert(has_value());
    return index_;
  }
  constexpr bool operator==(const OptionalIndex&) const = default;

 private:
  static constexpr AnIndex absent{0xffffffff};
  AnIndex index_ = absent;
};

static_assert(sizeof(OptionalIndex<std::uint32_t>) == sizeof(std::uint32_t));

}  // namespace contactsim

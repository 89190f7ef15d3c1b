// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>

#include "core/base/optional_index.hpp"

namespace contactsim {

class StateArchive;

/// A set of pairs, each of which two numbers stand for, such as two faces.
class PairSet {
 public:
  bool has(std::uint32_t a, std::uint32_t b) const { return keys_.contains(key(a, b)); }
  /// Whether any pair begins with a number.
  bool has_any(std::uint32_t a) const {
    const auto first = keys_.lower_bound(key(a, 0));
    return first != keys_.end() && *first >> 32 == a;
  }
  /// Returns whether the pair is new.
  bool add(std::uint32_t a, std::uint32_t b) { return keys_.insert(key(a, b)).second; }
  void clear() { keys_.clear(); }
  void remove(std::uint32_t a, std::uint32_t b) { keys_.erase(key(a, b)); }
  /// Goes over to other numbers; pairs of which one is removed are left out.
  ///   first, second  as ContactRemap has the numbers; empty: they stay
  void remap(std::span<const OptionalIndex<std::uint32_t>> first,
             std::span<const OptionalIndex<std::uint32_t>> second);
  void archive(const std::string& name, StateArchive& saved);

 private:
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) { return (std::uint64_t{a} << 32) | b; }

  std::set<std::uint64_t> keys_;
};

}  // namespace contactsim

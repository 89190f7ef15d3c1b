// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include "core/base/optional_index.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

/// Positions that stay as they are.
struct Unchanged {
  template <class AnIndex>
  AnIndex operator[](AnIndex position) const {
    return position;
  }
};

/// A set of pairs of two positions, such as two faces.
template <class First, class Second>
class PairSet {
 public:
  bool has(First a, Second b) const { return keys_.contains(key(a, b)); }
  /// Whether any pair begins with a position.
  bool has_any(First a) const {
    const auto first = keys_.lower_bound(key(a, {}));
    return first != keys_.end() && *first >> 32 == a.value;
  }
  /// Returns whether the pair is new.
  bool add(First a, Second b) { return keys_.insert(key(a, b)).second; }
  void clear() { keys_.clear(); }
  void remove(First a, Second b) { keys_.erase(key(a, b)); }
  /// Goes over to other positions; pairs of which one is removed are left out.
  ///   first, second  as ContactRemap has them, or Unchanged
  template <class FirstNow, class SecondNow>
  void remap(const FirstNow& first, const SecondNow& second) {
    std::set<std::uint64_t> after;
    for (const std::uint64_t known : keys_) {
      const OptionalIndex<First> a = first[First{static_cast<std::uint32_t>(known >> 32)}];
      const OptionalIndex<Second> b = second[Second{static_cast<std::uint32_t>(known)}];
      if (a && b) after.insert(key(*a, *b));
    }
    keys_ = std::move(after);
  }
  void archive(const std::string& name, StateArchive& saved) { saved.set(name, keys_); }

 private:
  static std::uint64_t key(First a, Second b) { return (std::uint64_t{a.value} << 32) | b.value; }

  std::set<std::uint64_t> keys_;
};

}  // namespace contactsim

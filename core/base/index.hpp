// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace contactsim {

/// A position of one kind, from 0. Positions of two kinds are two types, so that they do not mix.
///   Kind  its name only
template <class Kind>
struct Index {
  using Scalar = std::uint32_t;  ///< that archives save
  std::uint32_t value = 0;
  auto operator<=>(const Index&) const = default;
};

/// The number of a position, typed or not.
constexpr std::uint32_t number_of(std::uint32_t position) { return position; }
template <class Kind>
constexpr std::uint32_t number_of(Index<Kind> position) {
  return position.value;
}

/// The positions from one up to before another, for loops.
template <class AnIndex>
class IndexRange {
 public:
  class Iterator {
   public:
    using value_type = AnIndex;
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::input_iterator_tag;
    constexpr Iterator() = default;
    constexpr explicit Iterator(AnIndex index) : index_(index) {}
    constexpr AnIndex operator*() const { return index_; }
    constexpr Iterator& operator++() {
      ++index_.value;
      return *this;
    }
    constexpr Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    constexpr bool operator==(const Iterator&) const = default;

   private:
    AnIndex index_;
  };

  constexpr IndexRange() = default;
  constexpr IndexRange(AnIndex first, AnIndex last) : first_(first), last_(last) {}
  constexpr Iterator begin() const { return Iterator(first_); }
  constexpr Iterator end() const { return Iterator(last_); }
  constexpr std::size_t size() const { return last_.value - first_.value; }

 private:
  AnIndex first_, last_;
};

}  // namespace contactsim

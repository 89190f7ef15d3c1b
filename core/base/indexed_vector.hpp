// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <type_traits>
#include <vector>

#include "core/base/index.hpp"

namespace contactsim {

/// A vector that is asked by positions of its own kind only.
template <class AnIndex, class Value>
class IndexedVector : public std::vector<Value> {
  using Vector = std::vector<Value>;

 public:
  using Key = AnIndex;
  using Vector::Vector;

  decltype(auto) operator[](AnIndex index) { return Vector::operator[](index.value); }
  decltype(auto) operator[](AnIndex index) const { return Vector::operator[](index.value); }
  /// Position that the next value to be added gets.
  AnIndex next() const { return {static_cast<std::uint32_t>(this->size())}; }
};

/// A view of such a vector.
template <class AnIndex, class Value>
class IndexedSpan : public std::span<Value> {
  using Span = std::span<Value>;

 public:
  using Key = AnIndex;
  IndexedSpan() = default;
  IndexedSpan(IndexedVector<AnIndex, std::remove_const_t<Value>>& values) : Span(values) {}
  IndexedSpan(
      const IndexedVector<AnIndex, std::remove_const_t<Value>>& values) requires std::is_const_v<Value>
      : Span(values) {}

  Value& operator[](AnIndex index) const { return Span::operator[](index.value); }
};

/// Position of what an iterator points to.
template <class Indexed, class Iterator>
typename Indexed::Key index_of(const Indexed& values, Iterator where) {
  return {static_cast<std::uint32_t>(where - values.begin())};
}

/// All positions of a vector or a view.
template <class Indexed>
IndexRange<typename Indexed::Key> indices(const Indexed& values) {
  return {{}, {static_cast<std::uint32_t>(values.size())}};
}

}  // namespace contactsim

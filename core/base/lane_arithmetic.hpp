// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "core/base/lane_mask.hpp"

namespace contactsim {

/// What all kinds of lanes compute alike. Sums, products and quotients are IEEE's on every processor.
template <class Lanes, class Number>
class LaneArithmetic {
 public:
  using Registers = LaneRegisters<Number>;
  using Mask = MaskLanes<Lanes, std::conditional_t<sizeof(Number) == 8, std::int64_t, std::int32_t>>;
  using Numbers = std::array<Number, 64 / sizeof(Number)>;

  LaneArithmetic() = default;
  LaneArithmetic(Number a)
      : lanes_(map_registers<Registers>([&](const auto& zero) { return a - zero; }, Registers{})) {}
  LaneArithmetic(const Registers& lanes) : lanes_(lanes) {}

  friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return map([](const auto& x, const auto& y) { return x + y; }, a, b);
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return map([](const auto& x, const auto& y) { return x - y; }, a, b);
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return map([](const auto& x, const auto& y) { return x * y; }, a, b);
  }
  friend Lanes operator/(const Lanes& a, const Lanes& b) {
    return map([](const auto& x, const auto& y) { return x / y; }, a, b);
  }
  friend Lanes operator-(const Lanes& a) {
    return map([](const auto& x) { return -x; }, a);
  }
  friend Mask operator<(const Lanes& a, const Lanes& b) {
    return compare([](const auto& x, const auto& y) { return x < y; }, a, b);
  }
  friend Mask operator>(const Lanes& a, const Lanes& b) {
    return compare([](const auto& x, const auto& y) { return x > y; }, a, b);
  }
  friend Mask operator<=(const Lanes& a, const Lanes& b) {
    return compare([](const auto& x, const auto& y) { return x <= y; }, a, b);
  }
  friend Mask operator>=(const Lanes& a, const Lanes& b) {
    return compare([](const auto& x, const auto& y) { return x >= y; }, a, b);
  }
  friend Mask operator==(const Lanes& a, const Lanes& b) {
    return compare([](const auto& x, const auto& y) { return x == y; }, a, b);
  }
  friend Mask operator!=(const Lanes& a, const Lanes& b) {
    return compare([](const auto& x, const auto& y) { return x != y; }, a, b);
  }

  /// As std::min and std::max: this one where neither is less.
  Lanes min(const Lanes& b) const {
    return map([](const auto& x, const auto& y) { return y < x ? y : x; }, *this, b);
  }
  Lanes max(const Lanes& b) const {
    return map([](const auto& x, const auto& y) { return x < y ? y : x; }, *this, b);
  }
  const Registers& registers() const { return lanes_; }

 protected:
  template <class Function, class... Of>
  static Lanes map(const Function& f, const Of&... of) {
    return map_registers<Registers>(f, of.registers()...);
  }
  template <class Function>
  static Mask compare(const Function& f, const Lanes& a, const Lanes& b) {
    return map_registers<typename Mask::Registers>(f, a.registers(), b.registers());
  }

  alignas(64) Registers lanes_;
};

}  // namespace contactsim

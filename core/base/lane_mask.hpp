// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/base/lane_registers.hpp"

namespace contactsim {

/// Which of some Lanes something holds for.
///   Bits  an integer as large as their numbers: all of its bits, or none
template <class Lanes, class Bits>
class MaskLanes {
 public:
  using Registers = LaneRegisters<Bits>;
  static constexpr std::size_t width = 64 / sizeof(Bits);

  MaskLanes() = default;
  MaskLanes(const Registers& lanes) : lanes_(lanes) {}
  explicit MaskLanes(bool holds)
      : lanes_(map([&](const auto& none) { return none - (holds ? 1 : 0); }, Registers{})) {}
  /// From the lowest bits, one of each lane.
  static MaskLanes of_bits(unsigned bits) {
    static constexpr auto places = [] {
      std::array<Bits, width> of_lanes{};
      for (std::size_t lane = 0; lane < width; ++lane) of_lanes[lane] = Bits{1} << lane;
      return of_lanes;
    }();
    return map([&](const auto& place) { return ((place - place + static_cast<Bits>(bits)) & place) != 0; },
               std::bit_cast<Registers>(places));
  }

  friend MaskLanes operator&&(const MaskLanes& a, const MaskLanes& b) {
    return map([](const auto& x, const auto& y) { return x & y; }, a.lanes_, b.lanes_);
  }
  friend MaskLanes operator||(const MaskLanes& a, const MaskLanes& b) {
    return map([](const auto& x, const auto& y) { return x | y; }, a.lanes_, b.lanes_);
  }
  friend MaskLanes operator!(const MaskLanes& a) {
    return map([](const auto& x) { return ~x; }, a.lanes_);
  }
  bool operator()(std::ptrdiff_t lane) const { return numbers()[static_cast<std::size_t>(lane)] != 0; }
  bool any() const {
#ifdef __AVX512F__
    if constexpr (width == 8) return bytes() != 0;
    return bits() != 0;
#else
    auto either = lanes_.all[0];
    for (std::size_t k = 1; k < Registers::n; ++k) either |= lanes_.all[k];
    Bits any = 0;
    for (std::size_t k = 0; k < register_bytes / sizeof(Bits); ++k) any |= either[k];
    return any != 0;
#endif
  }
  bool all() const {
#ifdef __AVX512F__
    if constexpr (width == 8) return bytes() == ~std::uint64_t{0};
#endif
    return !(!*this).any();
  }
  /// The lanes as bits, the lowest for the first.
  std::uint32_t bits() const {
    std::uint32_t bits = 0;
    const auto of_lanes = numbers();
    for (std::size_t lane = 0; lane < width; ++lane)
      bits |= static_cast<std::uint32_t>(of_lanes[lane]) & std::uint32_t{1} << lane;
    return bits;
  }
  /// The one where it holds, the other elsewhere.
  Lanes select(const Lanes& where_it_holds, const Lanes& elsewhere) const {
    const auto choose = [](const auto& holds, const auto& x, const auto& y) { return holds ? x : y; };
    return map_registers<typename Lanes::Registers>(choose, lanes_, where_it_holds.registers(),
                                                    elsewhere.registers());
  }

 private:
#ifdef __AVX512F__
  /// A byte of each of eight lanes.
  std::uint64_t bytes() const {
    using Bytes [[gnu::vector_size(8)]] = std::int8_t;
    return std::bit_cast<std::uint64_t>(__builtin_convertvector(lanes_, Bytes));
  }
#endif
  std::array<Bits, width> numbers() const { return std::bit_cast<std::array<Bits, width>>(lanes_); }
  template <class Function>
  static Registers map(const Function& f, const auto&... of) {
    return map_registers<Registers>(f, of...);
  }

  Registers lanes_;
};

}  // namespace contactsim

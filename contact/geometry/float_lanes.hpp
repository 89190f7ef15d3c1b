// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "contact/geometry/lane_vector.hpp"

namespace contactsim {

/// Candidates are culled this many at a time, in single precision, one per lane.
inline constexpr std::size_t n_float_lanes = 16;

/// One single precision number of each lane.
class FloatLanes : public LaneArithmetic<FloatLanes, float> {
 public:
  FloatLanes() = default;
  FloatLanes(float a) : LaneArithmetic(a) {}
  FloatLanes(const Registers& lanes) : LaneArithmetic(lanes) {}
  explicit FloatLanes(const Numbers& numbers) : LaneArithmetic(std::bit_cast<Registers>(numbers)) {}
  FloatLanes& operator+=(const FloatLanes& b) { return *this = *this + b; }
  float operator[](std::size_t lane) const { return std::bit_cast<Numbers>(lanes_)[lane]; }
};
using FloatMask = FloatLanes::Mask;

/// Four numbers that are worked on at once.
using FourFloats [[gnu::vector_size(16)]] = float;

inline FloatLanes above_zero(const FloatLanes& a) { return (a > 0.0f).select(a, FloatLanes(0.0f)); }
inline FloatLanes largest(const FloatLanes& a, const FloatLanes& b) { return (a > b).select(a, b); }
inline FloatLanes magnitude(const FloatLanes& a) { return (a < 0.0f).select(-a, a); }

/// A vector in each lane.
using VectorLanes = LaneVector<FloatLanes>;

/// Sum of the magnitudes of the components, no less than the length.
inline FloatLanes taxicab(const VectorLanes& v) { return magnitude(v.x) + magnitude(v.y) + magnitude(v.z); }

/// The first of the lanes that are set as bits, of some.
inline std::size_t first_lane(std::uint32_t bits) { return static_cast<std::size_t>(std::countr_zero(bits)); }

/// Records of single precision numbers, one of each lane, number by number.
///   Record  trivially copyable, of numbers of four bytes alone, a multiple of four of them
template <class Record>
class RecordLanes {
 public:
  static constexpr std::size_t n_numbers = sizeof(Record) / sizeof(float);
  static_assert(n_numbers % 4 == 0 && sizeof(Record) == n_numbers * sizeof(float));

  /// Takes over the records of the first n lanes. What the lanes after them hold means nothing.
  ///   record_of  (std::size_t lane) -> const Record&
  template <class RecordOf>
  void fill(std::size_t n, const RecordOf& record_of) {
    std::size_t lane = 0;
    for (; lane < n; lane += 4) {
      const std::size_t last = n - 1;
      fill_four(lane, record_of(lane), record_of(std::min(lane + 1, last)),
                record_of(std::min(lane + 2, last)), record_of(std::min(lane + 3, last)));
    }
    for (; lane < n_float_lanes; lane += 4) {
      for (std::size_t i = 0; i < n_numbers; ++i) set_four(i, lane, FourFloats{});
    }
  }
  FloatLanes operator[](std::size_t number) const { return FloatLanes(numbers_[number]); }
  VectorLanes vector(std::size_t first) const {
    return {(*this)[first], (*this)[first + 1], (*this)[first + 2]};
  }

 private:
  static FourFloats four_of(const Record& record, std::size_t first) {
    FourFloats four;
    std::memcpy(&four, reinterpret_cast<const char*>(&record) + first * sizeof(float), sizeof four);
    return four;
  }
  /// Four numbers of four records at a time change from a record each to a number each.
  void fill_four(std::size_t lane, const Record& a, const Record& b, const Record& c, const Record& d) {
    for (std::size_t i = 0; i < n_numbers; i += 4) {
      const FourFloats of_a = four_of(a, i), of_b = four_of(b, i), of_c = four_of(c, i), of_d = four_of(d, i);
      const FourFloats low_ab = __builtin_shufflevector(of_a, of_b, 0, 4, 1, 5),
                       low_cd = __builtin_shufflevector(of_c, of_d, 0, 4, 1, 5),
                       high_ab = __builtin_shufflevector(of_a, of_b, 2, 6, 3, 7),
                       high_cd = __builtin_shufflevector(of_c, of_d, 2, 6, 3, 7);
      set_four(i, lane, __builtin_shufflevector(low_ab, low_cd, 0, 1, 4, 5));
      set_four(i + 1, lane, __builtin_shufflevector(low_ab, low_cd, 2, 3, 6, 7));
      set_four(i + 2, lane, __builtin_shufflevector(high_ab, high_cd, 0, 1, 4, 5));
      set_four(i + 3, lane, __builtin_shufflevector(high_ab, high_cd, 2, 3, 6, 7));
    }
  }
  void set_four(std::size_t number, std::size_t lane, const FourFloats& four) {
    std::memcpy(numbers_[number].data() + lane, &four, sizeof four);
  }

  alignas(64) std::array<std::array<float, n_float_lanes>, n_numbers> numbers_;
};

}  // namespace contactsim

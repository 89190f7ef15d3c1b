// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <cstring>

namespace contactsim {

/// Candidates are culled this many at a time, in single precision, one per lane.
inline constexpr std::size_t n_float_lanes = 16;
using FloatLanes [[gnu::vector_size(n_float_lanes * sizeof(float))]] = float;
/// What comparisons of lanes give: all bits of a lane, or none.
using TruthLanes [[gnu::vector_size(n_float_lanes * sizeof(float))]] = std::int32_t;

inline FloatLanes above_zero(const FloatLanes& a) { return a > 0.0f ? a : FloatLanes{}; }
inline FloatLanes largest(const FloatLanes& a, const FloatLanes& b) { return a > b ? a : b; }
inline FloatLanes magnitude(const FloatLanes& a) { return a < 0.0f ? -a : a; }

/// A vector in each lane.
struct VectorLanes {
  FloatLanes x, y, z;

  VectorLanes operator-(const VectorLanes& other) const { return {x - other.x, y - other.y, z - other.z}; }
  FloatLanes dot(const VectorLanes& other) const { return x * other.x + y * other.y + z * other.z; }
  VectorLanes cross(const VectorLanes& other) const {
    return {y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x};
  }
  /// The same one in all lanes.
  static VectorLanes all(const Eigen::Vector3f& v) {
    return {FloatLanes{} + v[0], FloatLanes{} + v[1], FloatLanes{} + v[2]};
  }
};

/// The lanes, as bits, of which something is true.
inline std::uint32_t bits_of(const TruthLanes& truth) {
  std::uint32_t bits = 0;
  for (std::size_t lane = 0; lane < n_float_lanes; ++lane)
    bits |= static_cast<std::uint32_t>(truth[lane] & 1) << lane;
  return bits;
}

/// Records of single precision numbers, one of each lane, number by number.
///   Record  trivially copyable, of numbers of four bytes alone
template <class Record>
class RecordLanes {
 public:
  static constexpr std::size_t n_numbers = sizeof(Record) / sizeof(float);

  void set(std::size_t lane, const Record& record) {
    std::array<float, n_numbers> numbers;
    std::memcpy(numbers.data(), &record, sizeof record);
    for (std::size_t i = 0; i < n_numbers; ++i) numbers_[i][lane] = numbers[i];
  }
  FloatLanes operator[](std::size_t number) const {
    FloatLanes lanes;
    std::memcpy(&lanes, numbers_[number].data(), sizeof lanes);
    return lanes;
  }
  VectorLanes vector(std::size_t first) const {
    return {(*this)[first], (*this)[first + 1], (*this)[first + 2]};
  }

 private:
  alignas(64) std::array<std::array<float, n_float_lanes>, n_numbers> numbers_{};
};

}  // namespace contactsim

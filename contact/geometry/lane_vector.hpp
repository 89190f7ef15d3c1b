// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "core/base/lanes.hpp"

namespace contactsim {

/// A vector in each lane.
///   Number  one number of each lane
template <class Number>
struct LaneVector {
  Number x, y, z;

  /// The same one in all lanes.
  static LaneVector all(const Eigen::Matrix<typename Number::Numbers::value_type, 3, 1>& v) {
    return {Number(v[0]), Number(v[1]), Number(v[2])};
  }
  friend LaneVector operator+(const LaneVector& a, const LaneVector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend LaneVector operator-(const LaneVector& a, const LaneVector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend LaneVector operator*(const Number& factor, const LaneVector& a) {
    return {factor * a.x, factor * a.y, factor * a.z};
  }
  Number dot(const LaneVector& b) const { return x * b.x + y * b.y + z * b.z; }
  LaneVector cross(const LaneVector& b) const {
    return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x};
  }
};

/// Of eight pairs, in double precision.
using DoubleVectors = LaneVector<Lanes>;

inline DoubleVectors normalized(const DoubleVectors& v) {
  const Lanes length = v.dot(v).sqrt();
  return {v.x / length, v.y / length, v.z / length};
}
inline Lanes select(const LaneMask& holds, const Lanes& where_it_holds, const Lanes& elsewhere) {
  return holds.select(where_it_holds, elsewhere);
}
inline DoubleVectors select(const LaneMask& holds, const DoubleVectors& where_it_holds,
                            const DoubleVectors& elsewhere) {
  return {holds.select(where_it_holds.x, elsewhere.x), holds.select(where_it_holds.y, elsewhere.y),
          holds.select(where_it_holds.z, elsewhere.z)};
}
inline Eigen::Vector3d vector_in(const DoubleVectors& v, Eigen::Index lane) {
  return {v.x(lane), v.y(lane), v.z(lane)};
}
inline void set_lane(Eigen::Index lane, const Eigen::Vector3d& vector, DoubleVectors& v) {
  v.x(lane) = vector[0];
  v.y(lane) = vector[1];
  v.z(lane) = vector[2];
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "core/base/lanes.hpp"

namespace contactsim {

/// What formulas ask that stand once for a number of one pair, a double, and for those of eight, Lanes.
inline bool any(bool holds) { return holds; }
inline bool any(const LaneMask& holds) { return holds.any(); }
inline double select(bool holds, double where_it_holds, double elsewhere) {
  return holds ? where_it_holds : elsewhere;
}
inline Lanes select(const LaneMask& holds, const Lanes& where_it_holds, const Lanes& elsewhere) {
  return holds.select(where_it_holds, elsewhere);
}
inline double square_root(double a) { return std::sqrt(a); }
inline Lanes square_root(const Lanes& a) { return a.sqrt(); }

/// A vector in each lane, or one.
///   Number  one number of each lane, or a double
template <class Number>
struct LaneVector {
  Number x, y, z;

  /// The same one in all lanes.
  ///   v  three numbers
  template <class Vector>
  static LaneVector all(const Vector& v) {
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

template <class Mask, class Number>
LaneVector<Number> select(const Mask& holds, const LaneVector<Number>& where_it_holds,
                          const LaneVector<Number>& elsewhere) {
  return {select(holds, where_it_holds.x, elsewhere.x), select(holds, where_it_holds.y, elsewhere.y),
          select(holds, where_it_holds.z, elsewhere.z)};
}

/// Of length 1; what has no length stays.
template <class Number>
LaneVector<Number> normalized(const LaneVector<Number>& v) {
  const Number square = v.dot(v), length = select(square > 0.0, square_root(square), 1.0);
  return {v.x / length, v.y / length, v.z / length};
}

/// Of eight pairs, in double precision.
using DoubleVectors = LaneVector<Lanes>;

inline Eigen::Vector3d vector_in(const DoubleVectors& v, Eigen::Index lane) {
  return {v.x(lane), v.y(lane), v.z(lane)};
}
inline void set_lane(Eigen::Index lane, const Eigen::Vector3d& vector, DoubleVectors& v) {
  v.x(lane) = vector[0];
  v.y(lane) = vector[1];
  v.z(lane) = vector[2];
}

}  // namespace contactsim

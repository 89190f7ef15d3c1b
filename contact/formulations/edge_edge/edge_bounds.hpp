// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <span>

#include "contact/mesh/contact_kinematics.hpp"
#include "core/base/bytes_of.hpp"
#include "core/base/indexed_vector.hpp"

namespace contactsim {

/// Where edges are, in half a cache line each: enough to see that most candidates do not cross.
class EdgeBounds {
 public:
  /// Takes over where edges are.
  ///   depth_before  how deep each was in the last step: those that touched something count always [length]
  void update(const ContactKinematics& kinematics, const IndexedVector<EdgeIndex, float>& depth_before);
  /// Whether two edges may cross, seen along the normal of both, at whatever distance; always unless both are
  /// sharp and touched nothing. Says yes rather too often.
  bool may_cross(EdgeIndex first, EdgeIndex second) const;
  std::size_t bytes() const { return bytes_of(bounds_); }

 private:
  struct alignas(32) Bound {
    Eigen::Vector3f from, along;  // first node, and from there to the second one [length]
    float length;                 // not a number of an edge that counts always
  };
  IndexedVector<EdgeIndex, Bound> bounds_;
  float rounding_ = 0.0f;  // of positions in single precision, at most [length]
};

inline bool EdgeBounds::may_cross(EdgeIndex first, EdgeIndex second) const {
  const Bound &a = bounds_[first], &b = bounds_[second];
  // From which angle on edges cross, and how far beside each other they still do over their lengths [1]: less
  // strict than find_edge_gap().
  constexpr float sine_squared = 0.02f, beside = 1e-4f;
  const Eigen::Vector3f normal = a.along.cross(b.along), apart = b.from - a.from;
  const float square = normal.squaredNorm(), lengths = a.length * b.length;
  // Comparisons with what is not a number are false.
  if (square <= sine_squared * lengths * lengths) return false;
  const float s = apart.cross(b.along).dot(normal), t = apart.cross(a.along).dot(normal);
  // With a size L the places along the edges are wrong by |n| |p| (e + L r) where positions are by e.
  const float size = apart.lpNorm<1>() + a.length + b.length;
  const float slack = std::sqrt(square) * (rounding_ + 2e-5f * size);
  const float below = beside * square, above = (1.0f + beside) * square;
  return !(s < -below - slack * b.length || s > above + slack * b.length || t < -below - slack * a.length ||
           t > above + slack * a.length);
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "contact/geometry/float_lanes.hpp"
#include "contact/geometry/float_positions.hpp"
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
  /// Some pairs of edges.
  struct Pairs {
    std::array<EdgeIndex, n_float_lanes> first, second;
    std::size_t n = 0;

    bool are_full() const { return n == n_float_lanes; }
    void add(EdgeIndex a, EdgeIndex b) {
      first[n] = a;
      second[n++] = b;
    }
  };
  /// Which pairs, as bits, may cross, seen along the normal of both, at whatever distance; those always that
  /// are not both sharp, or of which one touched something. Says yes rather too often.
  std::uint32_t may_cross(const Pairs& pairs) const;
  std::size_t bytes() const { return bytes_of(bounds_); }

 private:
  struct alignas(32) Bound {
    Eigen::Vector3f from, along;  // first node, and from there to the second one [length]
    float length;                 // not a number of an edge that counts always
  };
  IndexedVector<EdgeIndex, Bound> bounds_;
  FloatPositions positions_;
};

}  // namespace contactsim

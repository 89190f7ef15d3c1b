// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "contact/geometry/float_lanes.hpp"
#include "contact/geometry/float_positions.hpp"
#include "contact/mesh/contact_kinematics.hpp"
#include "core/base/bytes_of.hpp"
#include "core/base/indexed_vector.hpp"

namespace contactsim {

/// Where edges are and how they move, a cache line each: enough to see that most candidates do not touch.
class EdgeBounds {
 public:
  /// Takes over where edges are.
  ///   edges         or those that are asked about from now on alone
  ///   depth_before  how deep each was in the last step: those that touched something count always [length]
  void update(const ContactKinematics& kinematics, std::span<const EdgeIndex> edges,
              const IndexedVector<EdgeIndex, float>& depth_before);
  /// Some pairs of edges.
  struct Pairs {
    std::array<EdgeIndex, n_float_lanes> first, second;
    std::array<std::size_t, n_float_lanes> position;  ///< among the candidates
    std::size_t n = 0;

    bool are_full() const { return n == n_float_lanes; }
    void add(EdgeIndex a, EdgeIndex b, std::size_t candidate) {
      first[n] = a;
      second[n] = b;
      position[n++] = candidate;
    }
  };
  /// How far apart along the normal of both edges may be that touch.
  struct Reach {
    double time = 0.0;   ///< within which they may close [time]
    double shift = 0.0;  ///< of their gap at most, either way [length]
    double depth = 1.0;  ///< over the thickness of an element [1]
  };
  /// Which pairs, as bits, may touch: seen along the normal of both they cross, and along it they are within
  /// reach; those always that are not both sharp, or of which one touched something. Says yes rather too
  /// often.
  std::uint32_t may_touch(const Pairs& pairs, const Reach& reach) const;
  /// Which pairs, as bits, may cross, however far apart along the normal of both, while nodes move by so
  /// much; those always that are not both sharp.
  ///   motion  [length]
  std::uint32_t may_cross(const Pairs& pairs, double motion) const;
  /// Has the bound of an edge fetched, while something else is done.
  [[gnu::always_inline]] void prefetch(EdgeIndex edge) const { __builtin_prefetch(&bounds_[edge]); }
  std::size_t bytes() const { return bytes_of(bounds_); }

 private:
  struct alignas(64) Bound {
    Eigen::Vector3f from, along;  // first node, and from there to the second one [length]
    float length = 0.0f;          // not a number of an edge that counts always
    float thickness = 0.0f;       // of its element [length]
    Eigen::Vector3f velocity;     // mean of the nodes [length/time]
    float spread = 0.0f;          // of their velocities around it, at most [length/time]
    float sharp_length = 0.0f;    // not a number of an edge that is not sharp [length]
    std::array<float, 3> unused{};
  };
  RecordLanes<Bound> bounds_of(const std::array<EdgeIndex, n_float_lanes>& edges, std::size_t n) const;

  IndexedVector<EdgeIndex, Bound> bounds_;
  FloatPositions positions_;
};

}  // namespace contactsim

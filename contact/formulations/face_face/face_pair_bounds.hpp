// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "contact/formulations/contact_step_context.hpp"
#include "contact/geometry/float_lanes.hpp"
#include "contact/geometry/float_positions.hpp"
#include "core/base/bytes_of.hpp"
#include "core/base/indexed_vector.hpp"

namespace contactsim {

/// Where faces are and how they move, a cache line each: enough to see that most candidates do not touch.
class FacePairBounds {
 public:
  /// Takes over the bounds of faces that are those of now.
  void update(const ContactKinematics& kinematics);
  /// Some pairs of faces.
  struct Pairs {
    std::array<FaceIndex, n_float_lanes> first, second;
    std::array<std::size_t, n_float_lanes> position;  ///< among the candidates
    std::size_t n = 0;

    bool are_full() const { return n == n_float_lanes; }
    void add(FaceIndex a, FaceIndex b, std::size_t candidate) {
      first[n] = a;
      second[n] = b;
      position[n++] = candidate;
    }
    /// All of them, as bits.
    std::uint32_t all() const { return (1u << n) - 1; }
  };
  /// Which pairs, as bits, may touch: may_touch() of bounds where the activation distance is what closes by
  /// the mean velocities of the faces, and more. Says yes wherever that does, and somewhat more often.
  ///   ahead  within which they may close [time]
  ///   reach  gaps up to it count however slow faces close [length]
  std::uint32_t may_touch(const Pairs& pairs, double ahead, double reach) const;
  /// Finds how far normals may turn while corners move by so much, before may_meet().
  ///   motion  [length]
  void find_turns(const ContactKinematics& kinematics, double motion) {
    kinematics.find_turns(motion, turns_);
  }
  /// Which pairs, as bits, may touch while corners stay in the range of motion of find_turns().
  ///   reach  gaps up to it count besides what may close [length]
  std::uint32_t may_meet(const Pairs& pairs, const CloseRange& range, double reach) const;
  /// Has the bound of a face fetched, while something else is done.
  [[gnu::always_inline]] void prefetch(FaceIndex face) const { __builtin_prefetch(&bounds_[face]); }
  std::size_t bytes() const { return bytes_of(bounds_) + bytes_of(turns_); }

 private:
  /// As a FaceBound has them, from an origin near all faces.
  struct alignas(64) Bound {
    Eigen::Vector3f centre;          // [length]
    float warp = 0.0f;               // [length]
    Eigen::Vector3f normal;          // unit [1]
    Eigen::Vector3f velocity;        // [length/time]
    Eigen::Vector3f half_0, half_1;  // [length]
  };
  struct BoundLanes;
  struct Apart;
  RecordLanes<Bound> bounds_of(const std::array<FaceIndex, n_float_lanes>& faces, std::size_t n) const;

  IndexedVector<FaceIndex, Bound> bounds_;
  IndexedVector<FaceIndex, float> turns_;  // by which normals may turn, of find_turns() [1]
  FloatPositions positions_;
};

}  // namespace contactsim

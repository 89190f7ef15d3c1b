// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "core/base/threads.hpp"

namespace contactsim {

/// Positions in single precision, from an origin near all of them, so that little is rounded off.
class FloatPositions {
 public:
  /// Begins anew.
  ///   origin  near the positions [length]
  void begin(const Eigen::Vector3d& origin) { origin_ = origin; }
  Eigen::Vector3f position(const Eigen::Vector3d& x) const { return (x - origin_).cast<float>(); }
  /// Takes notice of the positions of n items: how far off what is computed of some of them is.
  ///   n_roundings  of a position in that, each 2^-24 of the farthest coordinate
  ///   position_of  (std::uint32_t) -> position of an item [length]
  template <class PositionOf>
  void note_rounding(std::uint32_t n, float n_roundings, const PositionOf& position_of) {
    const float farthest = parallel_max(n, threads_for(n), 0.0f, [&](std::uint32_t i) {
      return position_of(i).template lpNorm<Eigen::Infinity>();
    });
    rounding_ = n_roundings * 0x1p-24f * farthest;
  }
  /// Of what is computed of positions, at most [length].
  float rounding() const { return rounding_; }

 private:
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  float rounding_ = 0.0f;
};

}  // namespace contactsim

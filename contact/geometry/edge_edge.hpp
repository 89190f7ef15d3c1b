// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

namespace contactsim {

/// The ends of a line between two nodes [length]; of a particle the same twice.
using Segment = Eigen::Matrix<double, 3, 2>;

/// Where two segments are near each other.
struct EdgePairPoint {
  double s = 0.0, t = 0.0;  ///< along the first and the second, 0 at the first node and 1 at the second [1]
  double length = 0.0;      ///< of the segments that lie along each other here; 0 where they cross [length]
  bool is_parallel = false;
};

/// The points where two segments are nearest: one where they cross, the two ends of the part in which they
/// lie along each other when they are parallel within 6 degrees.
class EdgePairPoints {
 public:
  EdgePairPoints(const Segment& first, const Segment& second);

  std::span<const EdgePairPoint> get() const { return {points_.data(), n_}; }

 private:
  bool add_parallel(const Segment& first, const Segment& second);

  std::array<EdgePairPoint, 2> points_;
  std::size_t n_ = 0;
};

/// The nearest points of two segments. Source: Ericson, Real-Time Collision Detection (2005), 5.1.9.
EdgePairPoint nearest_points(const Segment& first, const Segment& second);

}  // namespace contactsim

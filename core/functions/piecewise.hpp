// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/function.hpp"

namespace contactsim {

/// One point of a table.
struct FunctionPoint {
  double x = 0.0;  ///< [abscissa]
  double y = 0.0;  ///< [ordinate]
};

/// Straight lines between points; the end values are held outside, two points of one abscissa are a jump.
/// Finding the line takes O(log n).
/// Source: Aria 5.18, DEFINITION FOR FUNCTION: a piecewise linear function is not extrapolated.
class PiecewiseLinear {
 public:
  ///   points  at least one, x not decreasing and at most twice the same, their span finite
  ///   side    whose value a jump has at its abscissa: of the line that ends there or of the one that begins
  explicit PiecewiseLinear(std::vector<FunctionPoint> points,
                           DiscontinuitySide side = DiscontinuitySide::right);
  /// The value at x, exactly y at a point; NaN when x is NaN.
  double evaluate(double x) const;

 private:
  std::vector<FunctionPoint> points_;
  DiscontinuitySide side_;
};

/// Steps: from each point on its value, up to the next point. Before the first point its value is held.
/// Source: Aria 5.24, AT DISCONTINUITY EVALUATE TO.
class PiecewiseConstant {
 public:
  ///   points  at least one, x strictly increasing
  ///   side    whose value a point itself has: of the step that ends there or of the one that begins
  PiecewiseConstant(std::vector<FunctionPoint> points, DiscontinuitySide side);
  /// The value at x; NaN when x is NaN.
  double evaluate(double x) const;

 private:
  std::vector<FunctionPoint> points_;
  DiscontinuitySide side_;
};

}  // namespace contactsim

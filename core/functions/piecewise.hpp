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

/// Straight lines between points; the end values are held outside. Finding the line takes O(log n).
/// Source: Aria 5.18, DEFINITION FOR FUNCTION: a piecewise linear function is not extrapolated.
class PiecewiseLinear {
 public:
  ///   points  at least one, x strictly increasing, their span finite
  explicit PiecewiseLinear(std::vector<FunctionPoint> points);
  /// The value at x, exactly y at a point; NaN when x is NaN.
  double evaluate(double x) const;

 private:
  std::vector<FunctionPoint> points_;
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

// SPDX-License-Identifier: BSD-3-Clause
#include "core/functions/piecewise.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace contactsim {

PiecewiseLinear::PiecewiseLinear(std::vector<FunctionPoint> points, DiscontinuitySide side)
    : points_(std::move(points)), side_(side) {
  assert(!points_.empty());
}

double PiecewiseLinear::evaluate(double x) const {
  if (std::isnan(x)) return x;
  const bool is_left = side_ == DiscontinuitySide::left;
  const auto after = std::partition_point(points_.begin(), points_.end(), [&](const FunctionPoint& point) {
    return is_left ? point.x < x : point.x <= x;
  });
  if (after == points_.begin()) return points_.front().y;
  if (after == points_.end()) return points_.back().y;
  const FunctionPoint& a = after[-1];
  const FunctionPoint& b = *after;
  // Unlike a.y + share * (b.y - a.y), lerp does not overflow between huge values of both signs.
  return std::lerp(a.y, b.y, (x - a.x) / (b.x - a.x));
}

PiecewiseConstant::PiecewiseConstant(std::vector<FunctionPoint> points, DiscontinuitySide side)
    : points_(std::move(points)), side_(side) {
  assert(!points_.empty());
}

double PiecewiseConstant::evaluate(double x) const {
  if (std::isnan(x)) return x;
  const bool is_left = side_ == DiscontinuitySide::left;
  const auto after = std::partition_point(points_.begin(), points_.end(), [&](const FunctionPoint& point) {
    return is_left ? point.x < x : point.x <= x;
  });
  return after == points_.begin() ? points_.front().y : after[-1].y;
}

}  // namespace contactsim

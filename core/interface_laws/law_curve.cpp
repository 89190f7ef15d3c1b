// SPDX-License-Identifier: BSD-3-Clause
#include "core/interface_laws/law_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/functions/function.hpp"

namespace contactsim {

double LawCurve::integral(double x) const {
  double sum = 0.0, begin = 0.0;
  const auto add_up_to = [&](double end) {
    sum += (end - begin) * at(0.5 * (begin + end));  // exact where no point lies between
    begin = end;
  };
  for (const FunctionPoint& point : points_) {
    if (point.x > 0.0 && point.x < x) add_up_to(point.x);
  }
  add_up_to(x);
  return sum;
}

double LawCurve::steepest() const {
  double steepest = 0.0;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const FunctionPoint &a = points_[i - 1], &b = points_[i];
    steepest = std::max(steepest, std::abs((b.y - a.y) / (b.x - a.x)));
  }
  return steepest;
}

bool LawCurve::softens() const {
  double slope = std::numeric_limits<double>::infinity();
  for (const FunctionPoint& point : points_) {
    if (point.x <= 0.0) continue;
    constexpr double rounding = 1e-12;
    if (point.y < 0.0 || point.y / point.x > (1.0 + rounding) * slope) return false;
    slope = point.y / point.x;
  }
  return at(0.0) >= 0.0;
}

std::optional<LawCurve> make_law_curve(const DeckName& name, double scale,
                                       std::span<const FunctionDefinition> functions,
                                       Diagnostics& diagnostics) {
  const auto function = make_named_function(name, functions, diagnostics);
  if (!function) return std::nullopt;
  const auto found = std::find_if(functions.begin(), functions.end(),
                                  [&](const FunctionDefinition& f) { return f.name == name; });
  if (found == functions.end() || found->type != FunctionType::piecewise_linear) {
    diagnostics.add_error(
        name.location,
        fmt::format("the function '{}' of a friction model must be PIECEWISE LINEAR", name.text),
        "the law ends where its last line ends");
    return std::nullopt;
  }
  if (const auto jump = find_jump(*found)) {
    diagnostics.add_error(name.location,
                          fmt::format("the function '{}' of a friction model jumps at {}", name.text, *jump),
                          "give it a steep line");
    return std::nullopt;
  }
  std::vector<FunctionPoint> points;
  for (const FunctionValue& value : found->values) {
    const double x = found->x_scale * (value.abscissa + found->x_offset);
    points.push_back({x, scale * function->evaluate(x)});
  }
  return LawCurve(std::move(points));
}

}  // namespace contactsim

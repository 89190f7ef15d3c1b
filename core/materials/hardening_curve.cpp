// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/hardening_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/functions/function.hpp"

namespace contactsim {

namespace {

/// What is wrong with the points of a hardening function, for the user; empty when nothing is.
std::string problem_of(std::span<const FunctionPoint> points, double yield_stress) {
  constexpr double rounding = 1e-6;  // of a stress that is written twice
  const FunctionPoint& first = points.front();
  if (first.x != 0.0) return fmt::format("begins at the plastic strain {}; it must begin at 0", first.x);
  if (first.y != 0.0 && std::abs(first.y - yield_stress) > rounding * yield_stress) {
    return fmt::format(
        "begins at {}; it must begin at 0, if it is added to the yield stress, or at the yield stress {}",
        first.y, yield_stress);
  }
  const auto falls = std::ranges::adjacent_find(
      points, [](const FunctionPoint& a, const FunctionPoint& b) { return b.y < a.y; });
  if (falls == points.end()) return {};
  return fmt::format("falls from {} to {}; hardening must not fall", falls->y, std::next(falls)->y);
}

}  // namespace

HardeningCurve::HardeningCurve(std::span<const FunctionPoint> points) {
  assert(!points.empty() && points.front().x == 0.0);
  points_.clear();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const FunctionPoint& here = points[i];
    const FunctionPoint& next = points[std::min(i + 1, points.size() - 1)];
    const double slope = next.x > here.x ? (next.y - here.y) / (next.x - here.x) : 0.0;
    points_.push_back({here.x, here.y, slope});
  }
}

HardeningCurve::Place HardeningCurve::at(const Lanes& strain) const {
  const auto next = std::ranges::upper_bound(points_, strain.minCoeff(), {}, &Point::strain);
  // A strain that is not a number passes no point.
  const Point& first = next == points_.begin() ? points_.front() : *std::prev(next);
  Place place{Lanes::Constant(first.strain), Lanes::Constant(first.stress), Lanes::Constant(first.slope),
              static_cast<std::size_t>(next - points_.begin())};
  for (std::size_t i = place.next; i < points_.size(); ++i) {
    const LaneMask is_passed = points_[i].strain <= strain;
    if (!is_passed.any()) break;
    place.strain = is_passed.select(points_[i].strain, place.strain);
    place.stress = is_passed.select(points_[i].stress, place.stress);
    place.slope = is_passed.select(points_[i].slope, place.slope);
  }
  place.stress += place.slope * (strain - place.strain);
  place.strain = strain;
  return place;
}

std::optional<HardeningCurve> make_hardening_curve(const DeckName& name, double yield_stress,
                                                   std::span<const FunctionDefinition> functions,
                                                   Diagnostics& diagnostics) {
  const auto function = make_named_function(name, functions, diagnostics);
  if (!function) return std::nullopt;
  const auto fail = [&](std::string_view what) {
    diagnostics.add_error(name.location, fmt::format("the hardening function '{}' {}", name.text, what), "",
                          static_cast<int>(name.text.size()));
    return std::nullopt;
  };
  const auto found = std::ranges::find_if(functions, [&](const auto& f) { return f.name == name; });
  if (found == functions.end() || found->type != FunctionType::piecewise_linear)
    return fail("must be PIECEWISE LINEAR");
  if (const auto jump = find_jump(*found))
    return fail(fmt::format("jumps at {}; give it a steep line", *jump));
  std::vector<FunctionPoint> points;
  for (const FunctionValue& value : found->values) {
    const double x = found->x_scale * (value.abscissa + found->x_offset);
    points.push_back({x, function->evaluate(x)});
  }
  const std::string problem = problem_of(points, yield_stress);
  if (!problem.empty()) return fail(problem);
  const double added = points.front().y == 0.0 ? yield_stress : 0.0;
  for (FunctionPoint& point : points) point.y += added;
  return HardeningCurve(points);
}

}  // namespace contactsim

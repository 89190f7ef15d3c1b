// SPDX-License-Identifier: BSD-3-Clause
#include "core/functions/expression_functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace contactsim {

namespace {

using std::numbers::pi;
using Arguments = std::span<const double>;
using F = ExpressionFunction;
using enum ExpressionDialects;

/// Where x stands between begin (0) and end (1), held there outside. An empty ramp is a step at its begin.
double share_of(double x, double begin, double end) {
  if (std::isnan(x)) return x;
  if (x < begin) return 0.0;
  return x < end ? (x - begin) / (end - begin) : 1.0;
}

double cosine_ramp(double x, double begin, double end) {
  return (1.0 - std::cos(pi * share_of(x, begin, end))) / 2.0;
}

double cosine_ramp_of(Arguments a) {
  if (a.size() == 1) return cosine_ramp(a[0], 0.0, 1.0);
  return a.size() == 2 ? cosine_ramp(a[0], 0.0, a[1]) : cosine_ramp(a[0], a[1], a[2]);
}

double cycloidal_ramp(Arguments a) {
  const double share = share_of(a[0], a[1], a[2]);
  return share - std::sin(2.0 * pi * share) / (2.0 * pi);
}

double haversine_pulse(Arguments a) {
  const double share = share_of(a[0], a[1], a[2]);
  const double sine = share == 1.0 ? 0.0 : std::sin(pi * share);
  return sine * sine;
}

double unit_step(Arguments a) {
  if (std::isnan(a[0])) return a[0];
  return a[0] < a[1] || a[0] > a[2] ? 0.0 : 1.0;
}

/// 1 in a disc or ball of the radius, 0 outside, over a band of the width across its edge.
double fading_ball(double distance, double radius, double width) {
  return 1.0 - cosine_ramp(distance, radius - 0.5 * width, radius + 0.5 * width);
}

double angle_from_0(double x, double y) {
  const double angle = std::atan2(y, x);
  return angle < 0.0 ? angle + 2.0 * pi : angle;
}

double sign_of(double x) { return std::isnan(x) ? x : (x >= 0.0 ? 1.0 : -1.0); }

/// A NaN among the numbers wins, so that a lost value is not hidden by a limiter.
template <class IsBetter>
double extreme(Arguments a, IsBetter is_better) {
  double best = a[0];
  for (const double x : a.subspan(1)) {
    if (std::isnan(x) || is_better(x, best)) best = x;
  }
  return best;
}

double exponential_pdf(Arguments a) { return a[0] < 0.0 ? 0.0 : std::exp(-a[0] / a[1]) / a[1]; }

double gamma_pdf(Arguments a) {
  if (a[0] < 0.0) return 0.0;
  return std::pow(a[0], a[1] - 1.0) * std::exp(-a[0] / a[2]) / (std::tgamma(a[1]) * std::pow(a[2], a[1]));
}

double log_uniform_pdf(Arguments a) {
  return a[0] < a[1] || a[0] > a[2] ? 0.0 : 1.0 / ((std::log(a[2]) - std::log(a[1])) * a[0]);
}

double normal_pdf(Arguments a) {
  const double away = (a[0] - a[1]) / a[2];
  return std::exp(-0.5 * away * away) / (std::sqrt(2.0 * pi) * std::abs(a[2]));
}

double weibull_pdf(Arguments a) {
  if (a[0] < 0.0) return 0.0;
  const double ratio = a[0] / a[2];
  return a[1] / a[2] * std::pow(ratio, a[1] - 1.0) * std::exp(-std::pow(ratio, a[1]));
}

template <double (*f)(double)>
double unary(Arguments a) {
  return f(a[0]);
}

template <double (*f)(double, double)>
double binary(Arguments a) {
  return f(a[0], a[1]);
}

constexpr std::string_view no_chance = "the same deck must give the same results on every run and machine";

/// Sorted by name.
constexpr auto functions = std::to_array<F>({
    {"abs", "x", 1, 1, unary<std::fabs>, "Absolute value", all},
    {"acos", "x", 1, 1, unary<std::acos>, "Inverse cosine in radians", all},
    {"acosh", "x", 1, 1, unary<std::acosh>, "Inverse hyperbolic cosine", all},
    {"asin", "x", 1, 1, unary<std::asin>, "Inverse sine in radians", all},
    {"asinh", "x", 1, 1, unary<std::asinh>, "Inverse hyperbolic sine", all},
    {"atan", "x", 1, 1, unary<std::atan>, "Inverse tangent in radians", all},
    {"atan2", "y, x", 2, 2, binary<std::atan2>, "Angle of the point (x, y) in radians, from -pi to pi", all},
    {"atanh", "x", 1, 1, unary<std::atanh>, "Inverse hyperbolic tangent", all},
    {"ceil", "x", 1, 1, unary<std::ceil>, "Smallest integer not below x", all},
    {"cos", "x", 1, 1, unary<std::cos>, "Cosine of radians", all},
    {"cos_ramp", "x[, begin][, end]", 1, 3, cosine_ramp_of, "As cosine_ramp"},
    {"cosh", "x", 1, 1, unary<std::cosh>, "Hyperbolic cosine", all},
    {"cosine_ramp", "x[, begin][, end]", 1, 3, cosine_ramp_of,
     "Half a cosine from 0 at begin (0) to 1 at end (1); of two numbers the second is the end"},
    {"cycloidal_ramp", "x, begin, end", 3, 3, cycloidal_ramp,
     "From 0 at begin to 1 at end, slope and curvature 0 at both"},
    {"deg", "x", 1, 1, [](Arguments a) { return a[0] * 180.0 / pi; }, "Radians to degrees"},
    {"erf", "x", 1, 1, unary<std::erf>, "Error function", all},
    {"erfc", "x", 1, 1, unary<std::erfc>, "1 - erf(x)", all},
    {"exp", "x", 1, 1, unary<std::exp>, "e to the power x", all},
    {"exponential_pdf", "x, mean", 2, 2, exponential_pdf, "Density of the exponential distribution"},
    {"fabs", "x", 1, 1, unary<std::fabs>, "As abs"},
    {"floor", "x", 1, 1, unary<std::floor>, "Largest integer not above x", all},
    {"fmod", "x, y", 2, 2, binary<std::fmod>, "Remainder of x/y with the sign of x", all},
    {"fpart", "x", 1, 1, [](Arguments a) { return a[0] - std::trunc(a[0]); }, "x - ipart(x)"},
    {"gamma_pdf", "x, shape, scale", 3, 3, gamma_pdf, "Density of the gamma distribution"},
    {"haversine_pulse", "x, begin, end", 3, 3, haversine_pulse,
     "From 0 at begin over 1 halfway back to 0 at end"},
    {"ipart", "x", 1, 1, unary<std::trunc>, "x truncated towards 0"},
    {"linear_ramp", "x, begin, end", 3, 3, [](Arguments a) { return share_of(a[0], a[1], a[2]); },
     "A line from 0 at begin to 1 at end"},
    {"ln", "x", 1, 1, unary<std::log>, "Natural logarithm", all},
    {"log", "x", 1, 1, unary<std::log>, "Natural logarithm", all},
    {"log10", "x", 1, 1, unary<std::log10>, "Logarithm to base 10", all},
    {"log_uniform_pdf", "x, low, high", 3, 3, log_uniform_pdf, "Density of the log-uniform distribution"},
    {"max", "x, y[, z][, w]", 2, 4, [](Arguments a) { return extreme(a, std::greater<>()); },
     "The largest one"},
    {"min", "x, y[, z][, w]", 2, 4, [](Arguments a) { return extreme(a, std::less<>()); },
     "The smallest one"},
    {"mod", "x, y", 2, 2, binary<std::fmod>, "As fmod"},
    {"normal_pdf", "x, mean, deviation", 3, 3, normal_pdf, "Density of the normal distribution"},
    {"point2d", "x, y, radius, width", 4, 4,
     [](Arguments a) { return fading_ball(std::hypot(a[0], a[1]), a[2], a[3]); },
     "1 in a disc round the origin, 0 outside, fading over the width"},
    {"point3d", "x, y, z, radius, width", 5, 5,
     [](Arguments a) { return fading_ball(std::hypot(a[0], a[1], a[2]), a[3], a[4]); },
     "1 in a ball round the origin, 0 outside, fading over the width"},
    {"poltorectx", "r, angle", 2, 2, [](Arguments a) { return a[0] * std::cos(a[1]); }, "r * cos(angle)"},
    {"poltorecty", "r, angle", 2, 2, [](Arguments a) { return a[0] * std::sin(a[1]); }, "r * sin(angle)"},
    {"pow", "x, y", 2, 2, binary<std::pow>, "x to the power y, as x ^ y", all},
    {"rad", "x", 1, 1, [](Arguments a) { return a[0] * pi / 180.0; }, "Degrees to radians"},
    {"rand", "", 0, 0, nullptr, no_chance},
    {"random", "[seed]", 0, 1, nullptr, no_chance},
    {"randomize", "", 0, 0, nullptr, no_chance},
    {"recttopola", "x, y", 2, 2, binary<angle_from_0>, "Angle of the point (x, y), from 0 to 2 pi"},
    {"recttopolr", "x, y", 2, 2, binary<std::hypot>, "sqrt(x^2 + y^2)"},
    {"sign", "x", 1, 1, unary<sign_of>, "-1 of a negative x, else 1"},
    {"sin", "x", 1, 1, unary<std::sin>, "Sine of radians", all},
    {"sinh", "x", 1, 1, unary<std::sinh>, "Hyperbolic sine", all},
    {"sqrt", "x", 1, 1, unary<std::sqrt>, "Square root", all},
    {"srand", "seed", 1, 1, nullptr, no_chance},
    {"tan", "x", 1, 1, unary<std::tan>, "Tangent of radians", all},
    {"tanh", "x", 1, 1, unary<std::tanh>, "Hyperbolic tangent", all},
    {"time", "", 0, 0, nullptr, "it reads the clock; use an EXPRESSION VARIABLE that is GLOBAL TIME"},
    {"ts_normal", "t, x, y, z, mean, deviation, low, high", 8, 8, nullptr, no_chance},
    {"ts_random", "t, x, y, z", 4, 4, nullptr, no_chance},
    {"unit_step", "x, begin, end", 3, 3, unit_step, "1 from begin to end, 0 outside"},
    {"weibull_pdf", "x, shape, scale", 3, 3, weibull_pdf, "Density of the Weibull distribution"},
});

struct Constant {
  std::string_view name;
  double value;
};

constexpr auto constants = std::to_array<Constant>(
    {{"pi", pi}, {"two_pi", 2.0 * pi}, {"e", std::numbers::e}, {"true", 1.0}, {"false", 0.0}});

}  // namespace

std::span<const ExpressionFunction> expression_functions() { return functions; }

const ExpressionFunction* find_expression_function(std::string_view name) {
  const auto found = std::lower_bound(functions.begin(), functions.end(), name,
                                      [](const F& row, std::string_view value) { return row.name < value; });
  return found != functions.end() && found->name == name ? &*found : nullptr;
}

std::optional<double> find_expression_constant(std::string_view name) {
  const auto found = std::find_if(constants.begin(), constants.end(),
                                  [&](const Constant& constant) { return constant.name == name; });
  return found == constants.end() ? std::nullopt : std::optional(found->value);
}

}  // namespace contactsim

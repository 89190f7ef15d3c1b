// SPDX-License-Identifier: BSD-3-Clause
#include "core/interface_laws/pressure_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace contactsim {

namespace {

/// From here on the exponential law goes on straight, in clearances from where it begins: by then the
/// pressure is 130 000 times that of a gap of 0, and e^x would soon have no number.
constexpr double last_exponent = 10.0;

/// Depths at which an analytic function is looked at before the run, in whatever unit [length].
constexpr int first_power = -9, last_power = 2;

/// Parts of a depth over which an analytic function is integrated, and its slope looked for.
constexpr int n_parts = 16;

/// Points and weights of Gauss's rule of three points on [0, 1].
constexpr std::array<std::pair<double, double>, 3> gauss{
    {{0.11270166537925831, 5.0 / 18.0}, {0.5, 8.0 / 18.0}, {0.88729833462074169, 5.0 / 18.0}}};

/// What is wrong with pressures that follow one another; null if nothing is.
const char* find_fault(std::span<const FunctionPoint> points) {
  if (points.front().y != 0.0) return "does not begin at a pressure of 0";
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].y < 0.0) return "gives a negative pressure";
    if (points[i].y < points[i - 1].y) return "falls";
  }
  return points.back().y > 0.0 ? nullptr : "never presses";
}

std::vector<FunctionPoint> points_of_table(const FunctionDefinition& definition, const Function& function,
                                           double factor) {
  std::vector<FunctionPoint> points;
  for (const FunctionValue& value : definition.values) {
    const double x = definition.x_scale * (value.abscissa + definition.x_offset);
    points.push_back({x, factor * function.evaluate(x)});
  }
  return points;
}

/// An analytic function at depths of all sizes, as long as it has a value.
std::vector<FunctionPoint> sample(const Function& function, double factor) {
  std::vector<FunctionPoint> points{{0.0, factor * function.evaluate(0.0)}};
  for (int power = first_power; power <= last_power; ++power) {
    const double x = std::pow(10.0, power), y = factor * function.evaluate(x);
    if (!std::isfinite(y)) break;
    points.push_back({x, y});
  }
  return points;
}

}  // namespace

const PressureLaw::Line& PressureLaw::Lines::of(double depth) const {
  const auto after = std::ranges::upper_bound(lines, depth, {}, &Line::begin);
  return after == lines.begin() ? lines.front() : *(after - 1);
}

double PressureLaw::Lines::at(double depth) const {
  const Line& line = of(depth);
  return line.pressure + line.slope * (depth - line.begin);
}

double PressureLaw::Lines::potential(double depth) const {
  const Line& line = of(depth);
  const double way = depth - line.begin;
  return line.potential + (line.pressure + 0.5 * line.slope * way) * way;
}

double PressureLaw::Exponential::at(double depth) const {
  const double x = std::min(depth / clearance, last_exponent);
  return factor * x * std::expm1(x) + slope(depth) * std::max(0.0, depth - last_exponent * clearance);
}

/// The integral of x (e^x - 1) is (x - 1) e^x + 1 - x^2 / 2.
double PressureLaw::Exponential::potential(double depth) const {
  const double x = std::min(depth / clearance, last_exponent);
  const double beyond = std::max(0.0, depth - last_exponent * clearance);
  return factor * clearance * (x * std::exp(x) - std::expm1(x) - 0.5 * x * x) +
         (factor * x * std::expm1(x) + 0.5 * slope(depth) * beyond) * beyond;
}

double PressureLaw::Exponential::slope(double depth) const {
  const double x = std::min(depth / clearance, last_exponent);
  return factor / clearance * (std::expm1(x) + x * std::exp(x));
}

double PressureLaw::Analytic::at(double depth) const {
  return std::max(0.0, factor * function.evaluate(depth));
}

double PressureLaw::Analytic::potential(double depth) const {
  const double part = depth / n_parts;
  double sum = 0.0;
  for (int i = 0; i < n_parts; ++i) {
    for (const auto& [place, weight] : gauss) sum += weight * at((i + place) * part);
  }
  return sum * part;
}

double PressureLaw::Analytic::slope(double depth) const {
  const double part = std::max(depth, std::pow(10.0, first_power)) / n_parts;
  double steepest = 0.0;
  for (int i = 0; i < n_parts; ++i) steepest = std::max(steepest, (at((i + 1) * part) - at(i * part)) / part);
  return steepest;
}

PressureLaw PressureLaw::by_points(std::vector<FunctionPoint> points) {
  // What is 0 before the pressure begins is no part of the law.
  const auto begin = std::ranges::find_if(points, [](const FunctionPoint& point) { return point.y > 0.0; });
  if (begin > points.begin() + 1) points.erase(points.begin(), begin - 1);
  Lines law;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const FunctionPoint &a = points[i - 1], &b = points[i];
    Line line{a.x - points[0].x, a.y, (b.y - a.y) / (b.x - a.x)};
    line.steepest = std::max(line.slope, law.lines.empty() ? 0.0 : law.lines.back().steepest);
    if (!law.lines.empty()) line.potential = law.potential(line.begin);
    law.lines.push_back(line);
  }
  return {-points[0].x, std::move(law)};
}

PressureLaw PressureLaw::exponential(double pressure, double clearance) {
  return {clearance, Exponential{pressure / (std::numbers::e - 1.0), clearance}};
}

PressureLaw PressureLaw::by_function(Function function, double factor) {
  return {0.0, Analytic{std::move(function), factor}};
}

double PressureLaw::at(double depth) const {
  if (!(depth > 0.0)) return 0.0;
  return std::visit([&](const auto& form) { return form.at(depth); }, form_);
}

double PressureLaw::potential(double depth) const {
  if (!(depth > 0.0)) return 0.0;
  return std::visit([&](const auto& form) { return form.potential(depth); }, form_);
}

double PressureLaw::slope(double depth) const {
  return std::visit([&](const auto& form) { return form.slope(std::max(depth, 0.0)); }, form_);
}

std::optional<PressureLaw> make_pressure_law(const DeckName& name, double factor,
                                             std::span<const FunctionDefinition> functions,
                                             Diagnostics& diagnostics) {
  const auto function = make_named_function(name, functions, diagnostics);
  if (!function) return std::nullopt;
  const auto found = std::ranges::find(functions, name, &FunctionDefinition::name);
  const bool is_table = found != functions.end() && found->type == FunctionType::piecewise_linear;
  const bool is_analytic = found != functions.end() && found->type == FunctionType::analytic;
  const auto refuse = [&](const std::string& text, const char* hint) {
    diagnostics.add_error(name.location, text, hint);
    return std::nullopt;
  };
  if (!is_table && !(is_analytic && function->inputs().empty()))
    return refuse(
        fmt::format("the pressure function '{}' must be PIECEWISE LINEAR, or ANALYTIC of x", name.text),
        "its abscissa is the overclosure, below 0 a gap; its ordinate the pressure");
  if (const auto jump = is_table ? find_jump(*found) : std::nullopt)
    return refuse(fmt::format("the pressure function '{}' jumps at {}", name.text, *jump),
                  "give it a steep line");
  auto points = is_table ? points_of_table(*found, *function, factor) : sample(*function, factor);
  if (const char* fault = find_fault(points))
    return refuse(fmt::format("the pressure function '{}' {}", name.text, fault),
                  is_table ? "sides that close further press harder: (0, 0), then ascending pressures"
                           : "it is 0 at x = 0 and ascends; a pressure that begins before touch needs a "
                             "table, or an EXPONENTIAL PRESSURE MODEL");
  if (!is_table) return PressureLaw::by_function(*function, factor);
  if (points[points.size() - 2].y == points.back().y)
    diagnostics.add_warning(
        "pressure-function-flat", name.location,
        fmt::format("the pressure function '{}' ends level: what presses harder than {:.6g} goes through",
                    name.text, points.back().y),
        "the last two pressures say how it goes on");
  return PressureLaw::by_points(std::move(points));
}

}  // namespace contactsim

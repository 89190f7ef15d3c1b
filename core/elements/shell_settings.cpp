// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/shell_settings.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "core/base/names.hpp"

namespace contactsim {

namespace {

/// Legendre's polynomial of a degree at x, and its derivative.
struct Legendre {
  double value, slope;

  Legendre(std::int64_t degree, double x) {
    double before = 1.0;
    value = x;
    for (std::int64_t k = 2; k <= degree; ++k) {
      const auto n = static_cast<double>(k);
      const double next = ((2.0 * n - 1.0) * x * value - (n - 1.0) * before) / n;
      before = value;
      value = next;
    }
    slope = static_cast<double>(degree) * (x * value - before) / (x * x - 1.0);
  }
};

constexpr int newton_steps = 20;  // far more than it takes from these starts

std::vector<ShellLayer> gauss(std::int64_t n) {
  if (n == 1) return {{0.0, 1.0}};
  std::vector<ShellLayer> layers;
  for (std::int64_t i = n; i-- > 0;) {
    double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (static_cast<double>(n) + 0.5));
    for (int step = 0; step < newton_steps; ++step) {
      const Legendre p(n, x);
      x -= p.value / p.slope;
    }
    const double slope = Legendre(n, x).slope;
    layers.push_back({x, 1.0 / ((1.0 - x * x) * slope * slope)});
  }
  return layers;
}

/// Inner points are where the slope of the polynomial of degree n - 1 vanishes; the second derivative follows
/// from Legendre's equation.
std::vector<ShellLayer> lobatto(std::int64_t n) {
  if (n < 2) return {};
  const auto degree = static_cast<double>(n - 1), per_point = 1.0 / (static_cast<double>(n) * degree);
  std::vector<ShellLayer> layers{{-1.0, per_point}};
  for (std::int64_t i = n - 2; i > 0; --i) {
    double x = std::cos(std::numbers::pi * static_cast<double>(i) / degree);
    for (int step = 0; step < newton_steps; ++step) {
      const Legendre p(n - 1, x);
      const double curvature = (2.0 * x * p.slope - degree * (degree + 1.0) * p.value) / (1.0 - x * x);
      x -= p.slope / curvature;
    }
    const double value = Legendre(n - 1, x).value;
    layers.push_back({x, per_point / (value * value)});
  }
  layers.push_back({1.0, per_point});
  return layers;
}

std::vector<ShellLayer> evenly_spaced(std::int64_t n) {
  std::vector<ShellLayer> layers;
  const double gap = 2.0 / static_cast<double>(n - 1);
  for (std::int64_t i = 0; i < n; ++i) layers.push_back({-1.0 + static_cast<double>(i) * gap, 0.5 * gap});
  return layers;
}

std::vector<ShellLayer> trapezoid(std::int64_t n) {
  if (n == 1) return {{0.0, 1.0}};
  std::vector<ShellLayer> layers = evenly_spaced(n);
  layers.front().weight = layers.back().weight *= 0.5;
  if (n == 2) return layers;
  const double gap = 2.0 / static_cast<double>(n - 1), moved = 0.5 * gap / (6.0 * (2.0 - gap));
  layers.front().weight -= moved;
  layers.back().weight -= moved;
  layers[1].weight += moved;
  layers[layers.size() - 2].weight += moved;
  return layers;
}

std::vector<ShellLayer> simpsons(std::int64_t n) {
  if (n < 3 || n % 2 == 0) return {};
  std::vector<ShellLayer> layers = evenly_spaced(n);
  for (std::size_t i = 0; i < layers.size(); ++i) layers[i].weight *= (i % 2 == 1 ? 4.0 : 2.0) / 3.0;
  layers.front().weight *= 0.5;
  layers.back().weight *= 0.5;
  return layers;
}

}  // namespace

std::span<const std::string_view> layer_rules() {
  static constexpr std::array<std::string_view, 4> rules{"gauss", "lobatto", "simpsons", "trapezoid"};
  return rules;
}

std::vector<ShellLayer> make_layers(std::string_view rule, std::int64_t n_points) {
  constexpr std::int64_t max_layers = 100;
  if (n_points < 1 || n_points > max_layers) return {};
  const std::string wanted = fold(rule);
  if (wanted == "gauss") return gauss(n_points);
  if (wanted == "lobatto") return lobatto(n_points);
  if (wanted == "simpsons") return simpsons(n_points);
  return wanted == "trapezoid" ? trapezoid(n_points) : std::vector<ShellLayer>{};
}

}  // namespace contactsim

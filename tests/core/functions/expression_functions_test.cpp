// SPDX-License-Identifier: BSD-3-Clause
#include "core/functions/expression_functions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

double call(std::string_view name, const std::vector<double>& arguments) {
  const ExpressionFunction* row = find_expression_function(name);
  REQUIRE(row != nullptr);
  return row->body(arguments);
}

/// The integral of f from 0 to `end`, by the midpoint rule on 100000 steps.
double integral(std::string_view name, double a, double b, double end) {
  double sum = 0.0;
  constexpr int n_steps = 100000;
  for (int i = 0; i < n_steps; ++i) sum += call(name, {end * (i + 0.5) / n_steps, a, b});
  return sum * end / n_steps;
}

}  // namespace

TEST_CASE("functions of expressions are sorted, documented and take what they say", "[core][expression]") {
  const auto rows = expression_functions();
  CHECK(
      std::is_sorted(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.name < b.name; }));
  for (const ExpressionFunction& row : rows) {
    INFO(row.name);
    CHECK(find_expression_function(row.name) == &row);
    CHECK(!row.help.empty());
    CHECK(row.min_arguments <= row.max_arguments);
    const auto commas = std::count(row.parameters.begin(), row.parameters.end(), ',');
    CHECK((row.parameters.empty() ? 0U : static_cast<std::size_t>(commas) + 1) == row.max_arguments);
    if (row.body == nullptr) continue;
    for (std::size_t n = row.min_arguments; n <= row.max_arguments; ++n) {
      CHECK(std::isfinite(row.body(std::vector<double>(n, 1.0))) ==
            (row.name != "atanh" && row.name != "log_uniform_pdf"));
    }
  }
  CHECK(find_expression_function("sine") == nullptr);
}

TEST_CASE("roundings and remainders of expressions keep the sign", "[core][expression]") {
  CHECK(call("ipart", {-9.25}) == -9.0);
  CHECK(call("fpart", {-9.25}) == -0.25);
  CHECK(call("ceil", {-0.5}) == 0.0);
  CHECK(call("floor", {-0.5}) == -1.0);
  CHECK(call("mod", {-9.0, 4.0}) == -1.0);
  CHECK(call("fmod", {9.5, -4.0}) == 1.5);
  CHECK(call("sign", {-0.1}) == -1.0);
  CHECK(call("sign", {0.0}) == 1.0);
  CHECK(call("max", {1.0, 4.0, 2.0}) == 4.0);
  CHECK(call("min", {3.0, 4.0, 2.0, 5.0}) == 2.0);
}

TEST_CASE("angles of expressions are radians", "[core][expression]") {
  using std::numbers::pi;
  CHECK(call("deg", {pi}) == Approx(180.0));
  CHECK(call("rad", {90.0}) == Approx(pi / 2.0));
  CHECK(call("atan2", {-1.0, 0.0}) == Approx(-pi / 2.0));
  CHECK(call("recttopola", {0.0, -1.0}) == Approx(1.5 * pi));
  CHECK(call("recttopolr", {3.0, 4.0}) == 5.0);
  CHECK(call("poltorectx", {2.0, pi / 3.0}) == Approx(1.0));
  CHECK(call("poltorecty", {2.0, pi / 6.0}) == Approx(1.0));
  CHECK(call("log", {std::numbers::e}) == Approx(1.0));
}

TEST_CASE("ramps of expressions hold their ends", "[core][expression]") {
  for (const std::string name : {"linear_ramp", "cosine_ramp", "cycloidal_ramp"}) {
    INFO(name);
    CHECK(call(name, {1.0, 2.0, 6.0}) == 0.0);
    CHECK(call(name, {2.0, 2.0, 6.0}) == 0.0);
    CHECK(call(name, {4.0, 2.0, 6.0}) == Approx(0.5));
    CHECK(call(name, {6.0, 2.0, 6.0}) == Approx(1.0));
    CHECK(call(name, {7.0, 2.0, 6.0}) == Approx(1.0));
    CHECK(call(name, {3.0, 3.0, 3.0}) == Approx(1.0));
  }
  CHECK(call("linear_ramp", {3.0, 2.0, 6.0}) == 0.25);
  CHECK(call("cosine_ramp", {1.0 / 3.0}) == Approx(0.25));
  CHECK(call("cos_ramp", {1.0, 3.0}) == Approx(0.25));
  CHECK(call("cycloidal_ramp", {0.25, 0.0, 1.0}) == Approx(0.25 - 0.5 / std::numbers::pi));
}

TEST_CASE("pulses of expressions vanish outside", "[core][expression]") {
  CHECK(call("haversine_pulse", {1.0, 2.0, 6.0}) == 0.0);
  CHECK(call("haversine_pulse", {3.0, 2.0, 6.0}) == Approx(0.5));
  CHECK(call("haversine_pulse", {4.0, 2.0, 6.0}) == Approx(1.0));
  CHECK(call("haversine_pulse", {6.0, 2.0, 6.0}) == 0.0);
  CHECK(call("unit_step", {1.0, 1.0, 2.0}) == 1.0);
  CHECK(call("unit_step", {2.0, 1.0, 2.0}) == 1.0);
  CHECK(call("unit_step", {2.5, 1.0, 2.0}) == 0.0);
  CHECK(call("point2d", {3.0, 4.0, 5.0, 1.0}) == Approx(0.5));
  CHECK(call("point3d", {0.0, 3.0, 4.0, 6.0, 1.0}) == 1.0);
  CHECK(call("point3d", {0.0, 3.0, 4.0, 4.0, 1.0}) == Approx(0.0).margin(1e-15));
}

TEST_CASE("densities of expressions hold a probability of one", "[core][expression]") {
  // The midpoint rule on a smooth density is good to the step squared; the tails cut off are below 1e-8.
  CHECK(integral("weibull_pdf", 2.0, 3.0, 30.0) == Approx(1.0).epsilon(1e-6));
  CHECK(integral("gamma_pdf", 3.0, 0.5, 30.0) == Approx(1.0).epsilon(1e-6));
  CHECK(integral("normal_pdf", 10.0, 1.0, 20.0) == Approx(1.0).epsilon(1e-6));
  CHECK(integral("log_uniform_pdf", 0.5, 2.5, 3.0) == Approx(1.0).epsilon(1e-4));
  CHECK(call("exponential_pdf", {0.0, 4.0}) == 0.25);
  CHECK(call("exponential_pdf", {4.0, 4.0}) == Approx(0.25 / std::numbers::e));
  CHECK(call("exponential_pdf", {-1.0, 4.0}) == 0.0);
}

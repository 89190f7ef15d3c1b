// SPDX-License-Identifier: BSD-3-Clause
#include "core/interface_laws/pressure_law.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/function_definition.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// The law of a table, or what is said of it.
struct Made {
  std::optional<PressureLaw> law;
  Diagnostics diagnostics;

  explicit Made(const FunctionDefinition& function, double factor = 1.0) {
    law = make_pressure_law(function.name, factor, {&function, 1}, diagnostics);
  }
  Made(const std::vector<std::pair<double, double>>& points, double factor = 1.0)
      : Made(table_function(FunctionType::piecewise_linear, points), factor) {}
  std::string text() const { return diagnostics.empty() ? "" : diagnostics.all().front().text; }
};

/// The force between depths is the slope of what is stored.
void check_potential(const PressureLaw& law, double deepest) {
  const double step = 1e-5 * deepest;
  for (double depth = 0.03 * deepest; depth < deepest; depth += 0.0517 * deepest) {
    const double rise = (law.potential(depth + step) - law.potential(depth - step)) / (2.0 * step);
    CHECK(rise == Approx(law.at(depth)).epsilon(1e-6).margin(1e-9 * law.at(deepest)));
    CHECK(law.slope(depth) * 1.0001 >= (law.at(depth) - law.at(depth - step)) / step);
  }
  CHECK(law.at(-step) == 0.0);
  CHECK(law.potential(-step) == 0.0);
}

}  // namespace

TEST_CASE("a table of pressures goes on along its last line", "[core][interface_laws][pressure]") {
  const Made made({{0.0, 0.0}, {0.01, 200.0}, {0.02, 1000.0}});
  REQUIRE(made.law);
  CHECK(made.diagnostics.empty());
  CHECK(made.law->begin_gap() == 0.0);
  CHECK(made.law->at(0.01) == Approx(200.0));
  CHECK(made.law->at(0.015) == Approx(600.0));
  CHECK(made.law->at(0.03) == Approx(1800.0));
  CHECK(made.law->potential(0.01) == Approx(1.0));
  CHECK(made.law->potential(0.02) == Approx(7.0));
  CHECK(made.law->potential(0.03) == Approx(21.0));
  CHECK(made.law->slope(0.005) == Approx(2e4));
  CHECK(made.law->slope(0.5) == Approx(8e4));
  CHECK(made.law->slope(-1.0) == Approx(2e4));
  check_potential(*made.law, 0.04);
}

TEST_CASE("a pressure may begin before touch or behind it", "[core][interface_laws][pressure]") {
  const Made soft({{-0.5, 0.0}, {-0.02, 0.0}, {0.0, 100.0}, {0.01, 400.0}}, 2.0);
  REQUIRE(soft.law);
  CHECK(soft.law->begin_gap() == 0.02);
  CHECK(soft.law->at(0.01) == Approx(100.0));
  CHECK(soft.law->at(0.03) == Approx(800.0));
  check_potential(*soft.law, 0.05);
  const Made late({{0.01, 0.0}, {0.02, 100.0}});
  REQUIRE(late.law);
  CHECK(late.law->begin_gap() == -0.01);
}

TEST_CASE("the exponential law has its pressure at touch and ends at its clearance",
          "[core][interface_laws][pressure]") {
  const PressureLaw law = PressureLaw::exponential(100.0, 0.01);
  CHECK(law.begin_gap() == 0.01);
  CHECK(law.at(0.01) == Approx(100.0));
  CHECK(law.at(0.005) == Approx(18.877).epsilon(1e-4));
  CHECK(law.at(0.02) == Approx(743.66).epsilon(1e-4));
  check_potential(law, 0.15);
  // From ten clearances on it is a line.
  CHECK(law.at(0.2) - law.at(0.15) == Approx(law.at(0.15) - law.at(0.1)));
  CHECK(std::isfinite(law.potential(1e3)));
}

TEST_CASE("a pressure may be an analytic function", "[core][interface_laws][pressure]") {
  const Made made(analytic_function("1e4 * (exp(50 * x) - 1)"));
  REQUIRE(made.law);
  CHECK(made.law->at(0.01) == Approx(1e4 * std::expm1(0.5)));
  CHECK(made.law->potential(0.01) == Approx(1e4 * (std::expm1(0.5) / 50.0 - 0.01)).epsilon(1e-9));
  CHECK(made.law->slope(0.01) == Approx(5e5 * std::exp(0.5)).epsilon(0.05));
}

TEST_CASE("what is no pressure is reported", "[core][interface_laws][pressure]") {
  CHECK(Made({{0.0, 0.0}, {0.01, 200.0}, {0.02, 100.0}}).text() == "the pressure function 'f' falls");
  CHECK(Made({{0.0, 0.0}, {0.01, 200.0}, {0.01, 300.0}}).text() == "the pressure function 'f' jumps at 0.01");
  CHECK(Made({{0.0, 5.0}, {0.01, 200.0}}).text() ==
        "the pressure function 'f' does not begin at a pressure of 0");
  CHECK(Made({{0.0, 0.0}, {0.01, -200.0}}).text() == "the pressure function 'f' gives a negative pressure");
  CHECK(Made({{0.0, 0.0}, {0.01, 0.0}}).text() == "the pressure function 'f' never presses");
  CHECK(Made({{0.0, 0.0}}).text() == "the pressure function 'f' never presses");
  CHECK(Made(analytic_function("1 + x")).text() ==
        "the pressure function 'f' does not begin at a pressure of 0");
  CHECK(Made(analytic_function("-x")).text() == "the pressure function 'f' gives a negative pressure");
  const Made steps(table_function(FunctionType::piecewise_constant, {{0.0, 0.0}, {1.0, 1.0}}));
  CHECK(steps.text() == "the pressure function 'f' must be PIECEWISE LINEAR, or ANALYTIC of x");
  const Made flat({{0.0, 0.0}, {0.01, 200.0}, {0.02, 200.0}});
  CHECK(flat.law);
  CHECK(flat.text() == "the pressure function 'f' ends level: what presses harder than 200 goes through");
}

// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/hardening_curve.hpp"

#include "support/catch.hpp"
#include "support/function_definition.hpp"

using namespace contactsim;

namespace {

using Points = std::vector<std::pair<double, double>>;

std::optional<HardeningCurve> curve_of(const FunctionDefinition& function, Diagnostics& diagnostics) {
  return make_hardening_curve({"f", {}}, 200.0, {&function, 1}, diagnostics);
}

HardeningCurve curve_of(const Points& points) {
  Diagnostics diagnostics;
  const auto curve = curve_of(table_function(FunctionType::piecewise_linear, points), diagnostics);
  REQUIRE(curve);
  CHECK(diagnostics.empty());
  return *curve;
}

std::string error_of(const FunctionDefinition& function) {
  Diagnostics diagnostics;
  CHECK_FALSE(curve_of(function, diagnostics));
  REQUIRE(diagnostics.error_count() == 1);
  return diagnostics.all()[0].text;
}

std::string error_of(const Points& points) {
  return error_of(table_function(FunctionType::piecewise_linear, points));
}

}  // namespace

TEST_CASE("a curve runs through its points and stays at the last", "[core][materials]") {
  const HardeningCurve curve = curve_of({{0.0, 200.0}, {0.1, 250.0}, {0.3, 260.0}});
  const Lanes strain(Lanes::Numbers{0.0, 0.05, 0.1, 0.2, 0.3, 0.4, 1e9, 0.1});
  const HardeningCurve::Place place = curve.at(strain);
  const double stress[] = {200.0, 225.0, 250.0, 255.0, 260.0, 260.0, 260.0, 250.0};
  const double slope[] = {500.0, 500.0, 50.0, 50.0, 0.0, 0.0, 0.0, 50.0};
  for (int lane = 0; lane < n_lanes; ++lane) {
    CHECK(place.stress(lane) == Approx(stress[lane]));
    CHECK(place.slope(lane) == Approx(slope[lane]));
  }
  CHECK(place.next == 1);
  CHECK(curve.at(Lanes::Constant(0.15)).next == 2);
  CHECK(curve.at(Lanes::Constant(0.1)).stress(0) == 250.0);
}

TEST_CASE("lanes climb a curve each as far as it may", "[core][materials]") {
  const HardeningCurve curve = curve_of({{0.0, 200.0}, {0.1, 250.0}, {0.3, 260.0}});
  const Lanes strain(Lanes::Numbers{0.0, 0.0, 0.0, 0.15, 0.15, 0.35, 0.02, 0.1});
  const Lanes limit(Lanes::Numbers{0.05, 0.1, 9.0, 0.2, 9.0, 9.0, 0.3, 0.1});
  const auto place = curve.climb(curve.at(strain), [&](const HardeningCurve::Point& point) -> LaneMask {
    return point.strain <= limit;
  });
  const double end[] = {0.0, 0.1, 0.3, 0.15, 0.3, 0.35, 0.3, 0.1};
  const double stress[] = {200.0, 250.0, 260.0, 252.5, 260.0, 260.0, 260.0, 250.0};
  for (int lane = 0; lane < n_lanes; ++lane) {
    CHECK(place.strain(lane) == end[lane]);
    CHECK(place.stress(lane) == Approx(stress[lane]));
  }
}

TEST_CASE("a function that begins at 0 is added to the yield stress", "[core][materials]") {
  const HardeningCurve added = curve_of({{0.0, 0.0}, {0.1, 50.0}}),
                       whole = curve_of({{0.0, 200.0}, {0.1, 250.0}});
  REQUIRE(added.points().size() == 2);
  for (std::size_t i = 0; i < 2; ++i) CHECK(added.points()[i].stress == whole.points()[i].stress);
  CHECK(curve_of({{0.0, 0.0}}).points()[0].stress == 200.0);
}

TEST_CASE("scales of a hardening function count", "[core][materials]") {
  FunctionDefinition function = table_function(FunctionType::piecewise_linear, {{0.0, 0.2}, {10.0, 0.3}});
  function.x_scale = 0.01;
  function.y_scale = 1000.0;
  Diagnostics diagnostics;
  const auto curve = curve_of(function, diagnostics);
  REQUIRE(curve);
  CHECK(curve->points()[1].strain == 0.1);
  CHECK(curve->points()[1].stress == Approx(300.0));
}

TEST_CASE("hardening functions that make no curve are refused", "[core][materials]") {
  CHECK(error_of({{0.1, 200.0}, {0.2, 250.0}}) ==
        "the hardening function 'f' begins at the plastic strain 0.1; it must begin at 0");
  CHECK(
      error_of({{0.0, 100.0}, {0.2, 250.0}}) ==
      "the hardening function 'f' begins at 100; it must begin at 0, if it is added to the yield stress, or "
      "at the yield stress 200");
  CHECK(error_of({{0.0, 200.0}, {0.2, 250.0}, {0.3, 240.0}}) ==
        "the hardening function 'f' falls from 250 to 240; hardening must not fall");
  CHECK(error_of({{0.0, 200.0}, {0.1, 250.0}, {0.1, 260.0}}) ==
        "the hardening function 'f' jumps at 0.1; give it a steep line");
  CHECK(error_of(table_function(FunctionType::piecewise_constant, {{0.0, 200.0}})) ==
        "the hardening function 'f' must be PIECEWISE LINEAR");
  CHECK(error_of(analytic_function("200")) == "the hardening function 'f' must be PIECEWISE LINEAR");
  CHECK(error_of({{0.0, 200.0}, {0.0, 250.0}}) ==
        "the hardening function 'f' jumps at 0; give it a steep line");
  Diagnostics diagnostics;
  CHECK_FALSE(make_hardening_curve({"g", {}}, 200.0, {}, diagnostics));
  CHECK(diagnostics.error_count() == 1);
}

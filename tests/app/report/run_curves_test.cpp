// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/run_curves.hpp"

#include <algorithm>

#include "contact/enforcement/contact_force.hpp"
#include "core/definition/contact.hpp"
#include "support/catch.hpp"
#include "support/flying_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Has curves look at a run, from its start to its end.
void look_at(FlyingCube& cube, RunCurves& curves) {
  cube.simulation.observe([&](RunEvent event, const Simulation& run) { curves.look(event, run); });
  cube.run_to_end();
}

const Curve& curve_of(const CurveChart& chart, const std::string& name) {
  const auto found = std::ranges::find(chart.curves, name, &Curve::name);
  REQUIRE(found != chart.curves.end());
  return *found;
}

}  // namespace

TEST_CASE("without a step there are no curves", "[app][report]") { CHECK(RunCurves().charts().empty()); }

TEST_CASE("curves have a value for the start and every step, of energies that are not zero",
          "[app][report]") {
  FlyingCube cube;
  RunCurves curves;
  look_at(cube, curves);
  const auto charts = curves.charts();
  REQUIRE(charts.size() == 3);
  CHECK(charts[0].title == "Energies");
  const auto n_steps = static_cast<std::size_t>(cube.simulation.state().step);
  REQUIRE(charts[0].times.size() == n_steps + 1);
  CHECK(charts[0].times.front() == 0.0);
  CHECK(charts[0].times.back() == cube.simulation.state().time);
  const Curve& kinetic = curve_of(charts[0], "kinetic");
  CHECK(kinetic.values.front() == Approx(0.5));
  CHECK(kinetic.values.back() == cube.simulation.state().energies.kinetic);
  CHECK(std::ranges::find(charts[0].curves, "friction", &Curve::name) == charts[0].curves.end());
}

TEST_CASE("curves of pairs that touch are zero before they do", "[app][report]") {
  FlyingCube cube({.time = "user time step = 1e-3\n"});  // ten steps up to the first touch
  RunCurves curves;
  look_at(cube, curves);
  const auto charts = curves.charts();
  CHECK(charts[1].title == "Contact force of pairs");
  CHECK(charts[2].title == "Deepest penetration of pairs");
  REQUIRE(charts[1].curves.size() == 1);
  const Curve& force = charts[1].curves[0];
  CHECK(force.name == "lower – upper");
  REQUIRE(force.values.size() == charts[1].times.size());
  CHECK(force.values.front() == 0.0);
  const double peak = cube.simulation.contact_force()->histories().front().peak_force;
  CHECK(*std::ranges::max_element(force.values) == Approx(peak));
  CHECK(charts[2].curves[0].values.size() == charts[1].times.size());
}

TEST_CASE("of a long run at most a thousand steps are kept, evenly", "[app][report]") {
  FlyingCube cube({.region = "", .time = "initial time step = 2e-4\nuser time step = 2e-4\n"});
  RunCurves curves;
  look_at(cube, curves);
  CHECK(cube.simulation.state().step >= 2500);
  const std::vector<double> times = curves.charts().at(0).times;
  CHECK(times.size() <= 1000);
  CHECK(times.size() > 500);
  for (std::size_t i = 2; i + 1 < times.size(); ++i)
    CHECK(times[i] - times[i - 1] == Approx(times[1] - times[0]));
  CHECK(times.back() == cube.simulation.state().time);
  for (const CurveChart& chart : curves.charts()) {
    for (const Curve& curve : chart.curves) CHECK(curve.values.size() == times.size());
  }
}

TEST_CASE("curves reach the end of a run of any length", "[app][report]") {
  FlyingCube cube({.time = "user time step = 5.006e-4\n"});
  RunCurves curves;
  look_at(cube, curves);
  REQUIRE(cube.simulation.state().step == 999);  // with that of the start a thousand
  const std::vector<double> times = curves.charts().at(0).times;
  CHECK(times.size() == 1000);
  CHECK(times.back() == cube.simulation.state().time);
}

TEST_CASE("pairs of a second procedure have curves of their own names", "[app][report]") {
  FlyingCube first, second({.contact = "begin interaction other\nside a = upper\nside b = lower\n"
                                       "constraint formulation = node_face\nend\n"});
  RunCurves curves;
  look_at(first, curves);
  const std::size_t n_first = curves.charts().at(1).times.size();
  look_at(second, curves);
  const CurveChart forces = curves.charts().at(1);
  REQUIRE(forces.curves.size() == 2);
  const std::vector<double>& of_first = curve_of(forces, "lower – upper").values;
  const std::vector<double>& of_second = curve_of(forces, "upper – lower").values;
  CHECK(std::all_of(of_first.begin() + static_cast<std::ptrdiff_t>(n_first), of_first.end(),
                    [](double value) { return value == 0.0; }));
  CHECK(std::all_of(of_second.begin(), of_second.begin() + static_cast<std::ptrdiff_t>(n_first),
                    [](double value) { return value == 0.0; }));
}

TEST_CASE("pairs of a procedure are zero in one without contact", "[app][report]") {
  FlyingCube first, second;
  Simulation alone({second.definition, second.definition.procedures.front(), second.region(), second.mesh},
                   {}, second.diagnostics);
  RunCurves curves;
  look_at(first, curves);
  alone.observe([&](RunEvent event, const Simulation& run) { curves.look(event, run); });
  alone.begin();
  alone.step();
  alone.finish();
  const CurveChart forces = curves.charts().at(1);
  REQUIRE(forces.curves.size() == 1);
  CHECK(forces.curves[0].values.size() == forces.times.size());
  CHECK(forces.curves[0].values.back() == 0.0);
}

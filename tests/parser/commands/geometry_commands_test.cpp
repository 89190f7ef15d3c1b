// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/geometry_commands.hpp"

#include "support/catch.hpp"
#include "support/parsed_deck.hpp"

using namespace contactsim;

TEST_CASE("points, directions, axes and coordinate systems are bound", "[parser][geometry]") {
  const auto [simulation, said] = parsed_sierra(
      "define point p with coordinates 1.0, 2.0, 3.0\n"
      "define direction down with vector 0.0 0.0 -10000.0\n"
      "define axis a with point p direction down\n"
      "define axis b with point p point q\n"
      "define coordinate system c cylindrical with point p point q point r\n"
      "define coordinate system d with point p point q point r\n");
  CHECK(said == "");
  CHECK(simulation.points.at(0).coordinates == Eigen::Vector3d(1, 2, 3));
  CHECK(simulation.directions.at(0).vector == Eigen::Vector3d(0, 0, -10000));
  REQUIRE(simulation.axes.size() == 2);
  CHECK(simulation.axes[0].direction->text == "down");
  CHECK_FALSE(simulation.axes[0].second_point);
  CHECK(simulation.axes[1].second_point->text == "q");
  REQUIRE(simulation.coordinate_systems.size() == 2);
  CHECK(simulation.coordinate_systems[0].kind == CoordinateSystemKind::cylindrical);
  CHECK(simulation.coordinate_systems[0].point_in_xz.text == "r");
  CHECK(simulation.coordinate_systems[1].kind == CoordinateSystemKind::rectangular);
}

TEST_CASE("mistakes in geometry are reported", "[parser][geometry]") {
  CHECK(parsed_sierra("define direction d with vector 0 0 0\n").messages ==
        "a.i:2:32: error: a direction must not be the zero vector\n");
  CHECK(parsed_sierra("define point p with coordinates 1 2\n").messages ==
        "a.i:2:1: error: expected a number after 'define point', found the end of the line\n");
  CHECK(parsed_sierra("define axis a with point p along d\n").messages ==
        "a.i:2:28: error: expected 'direction' in 'define axis', found 'along'\n");
  CHECK(
      parsed_sierra("define coordinate system c polar with point p point q point r\n").messages ==
      "a.i:2:28: error: expected one of rectangular, cylindrical, spherical for 'define coordinate system', "
      "found 'polar'\n");
  CHECK(parsed_sierra("define points p with coordinates 1 2 3\n").messages ==
        "a.i:2:1: error: unknown command 'define points p with ...' in 'sierra'; did you mean 'define "
        "point'?\n");
}

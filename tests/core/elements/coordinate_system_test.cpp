// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/coordinate_system.hpp"
#include "core/definition/simulation.hpp"

#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// Points o (1 0 0), z (1 2 0), x (4 5 0) and a system c through them: z along Y, x along X.
SimulationDefinition with_system(CoordinateSystemKind kind, const std::string& third = "x") {
  SimulationDefinition definition;
  definition.points = {
      {{"o", {}}, {1.0, 0.0, 0.0}}, {{"z", {}}, {1.0, 2.0, 0.0}}, {{"x", {}}, {4.0, 5.0, 0.0}}};
  definition.coordinate_systems = {{{"c", {}}, kind, {"o", {}}, {"z", {}}, {third, {}}}};
  return definition;
}

std::string error_of(const std::string& name, const SimulationDefinition& definition) {
  Diagnostics diagnostics;
  CHECK_FALSE(find_coordinate_system({name, {}}, definition, diagnostics));
  const Diagnostic& error = diagnostics.all().at(0);
  return error.hint.empty() ? error.text : error.text + ": " + error.hint;
}

}  // namespace

TEST_CASE("the third point of a coordinate system lays x at right angles to z", "[core][directions]") {
  Diagnostics diagnostics;
  const auto system =
      find_coordinate_system({"C", {}}, with_system(CoordinateSystemKind::rectangular), diagnostics);
  REQUIRE(system);
  const Matrix3d expected{{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, -1.0, 0.0}};
  CHECK((system->axes - expected).norm() < 1e-15);
  CHECK(system->directions_at(Vector3d(7.0, 8.0, 9.0)) == system->axes);
}

TEST_CASE("a cylindrical system points outwards, around and along its axis", "[core][directions]") {
  Diagnostics diagnostics;
  const auto system =
      find_coordinate_system({"c", {}}, with_system(CoordinateSystemKind::cylindrical), diagnostics);
  REQUIRE(system);
  const Matrix3d directions = system->directions_at(Vector3d(1.0, 7.0, 2.0));  // beside the axis, along Z
  CHECK((directions.col(0) - Vector3d::UnitZ()).norm() < 1e-15);
  CHECK((directions.col(1) - Vector3d::UnitX()).norm() < 1e-15);
  CHECK((directions.col(2) - Vector3d::UnitY()).norm() < 1e-15);
  CHECK(system->directions_at(Vector3d(1.0, 7.0, 0.0)) == system->axes);
}

TEST_CASE("coordinate systems that give no directions are errors", "[core][directions]") {
  CHECK(error_of("wheel", with_system(CoordinateSystemKind::rectangular)) ==
        "there is no coordinate system 'wheel'");
  SimulationDefinition definition = with_system(CoordinateSystemKind::rectangular, "corne");
  definition.points[2].name.text = "corner";
  CHECK(error_of("c", definition) == "there is no point 'corne': did you mean 'corner'?");
  CHECK(error_of("c", with_system(CoordinateSystemKind::rectangular, "z")) ==
        "the three points of the coordinate system 'c' lie on one line");
  CHECK(error_of("c", with_system(CoordinateSystemKind::spherical)) ==
        "the spherical system 'c' cannot give directions of a material");
}

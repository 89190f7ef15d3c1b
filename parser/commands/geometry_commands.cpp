// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/geometry_commands.hpp"

namespace contactsim {

namespace {

/// Reads "WITH <word>".
void expect_with(Arguments& arguments, std::string_view word) {
  arguments.expect("with");
  arguments.expect(word);
  arguments.skip_separator();
}

void read_point(Arguments& arguments, SimulationDefinition& simulation) {
  PointDefinition point{arguments.definition(NameKind::point), {}};
  expect_with(arguments, "coordinates");
  point.coordinates = arguments.vector();
  simulation.points.push_back(std::move(point));
}

void read_defined_direction(Arguments& arguments, SimulationDefinition& simulation) {
  DirectionDefinition direction{arguments.definition(NameKind::direction), {}};
  expect_with(arguments, "vector");
  const Word* first = arguments.at_end() ? nullptr : &arguments.peek();
  direction.vector = arguments.vector();
  if (direction.vector.isZero(0.0)) arguments.fail(*first, "a direction must not be the zero vector");
  simulation.directions.push_back(std::move(direction));
}

void read_axis(Arguments& arguments, SimulationDefinition& simulation) {
  AxisDefinition axis{arguments.definition(NameKind::axis), {}, {}, {}};
  expect_with(arguments, "point");
  axis.point = arguments.reference(NameKind::point);
  if (arguments.accept("point")) {
    axis.second_point = arguments.reference(NameKind::point);
  } else {
    arguments.expect("direction");
    axis.direction = arguments.reference(NameKind::direction);
  }
  simulation.axes.push_back(std::move(axis));
}

void read_coordinate_system(Arguments& arguments, SimulationDefinition& simulation) {
  static const Choices kinds({"rectangular", "cylindrical", "spherical"});
  CoordinateSystemDefinition system{arguments.definition(NameKind::coordinate_system), {}, {}, {}, {}};
  if (!arguments.is_next("with")) {
    system.kind = static_cast<CoordinateSystemKind>(arguments.choice(kinds));
  }
  expect_with(arguments, "point");
  system.origin = arguments.reference(NameKind::point);
  arguments.expect("point");
  system.point_on_z = arguments.reference(NameKind::point);
  arguments.expect("point");
  system.point_in_xz = arguments.reference(NameKind::point);
  simulation.coordinate_systems.push_back(std::move(system));
}

}  // namespace

std::vector<Row<SimulationDefinition>> geometry_rows() {
  return {
      row<SimulationDefinition>("define point", "<name> WITH COORDINATES <x> <y> <z>", read_point,
                                "A point [length]", "none")
          .defines(NameKind::point),
      row<SimulationDefinition>("define direction", "<name> WITH VECTOR <x> <y> <z>", read_defined_direction,
                                "A direction, of any length [1]", "none")
          .defines(NameKind::direction),
      row<SimulationDefinition>("define axis", "<name> WITH POINT <p> {DIRECTION <d>|POINT <q>}", read_axis,
                                "An axis through a point, along a direction or to a second point", "none")
          .defines(NameKind::axis)
          .references(NameKind::point)
          .references(NameKind::direction),
      row<SimulationDefinition>(
          "define coordinate system",
          "<name> [{RECTANGULAR|CYLINDRICAL|SPHERICAL}] WITH POINT <origin> POINT <on z> POINT <in xz>",
          read_coordinate_system, "A coordinate system through three points", "none")
          .defines(NameKind::coordinate_system)
          .references(NameKind::point),
  };
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/direction.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/condition_deck.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

struct Found {
  std::optional<Direction> direction;
  std::string messages;
};

Found find(const DirectionChoice& choice) {
  static const Mesh mesh = MeshBuilder().add_hexes({}).build();
  ConditionDeck deck(mesh, "");
  Found found{find_direction(choice, deck.scope()), ""};
  found.messages = deck.messages();
  return found;
}

DirectionChoice about(const std::string& axis) {
  DirectionChoice choice;
  choice.cylindrical_axis = DeckName{axis, {}};
  return choice;
}

}  // namespace

TEST_CASE("a direction is a unit vector, components are one each", "[core][conditions]") {
  DirectionChoice choice;
  choice.direction = DeckName{"SLANTED", {}};
  CHECK(sum_of_units(*find(choice).direction).isApprox(Eigen::Vector3d(0.6, 0.8, 0)));
  choice = {{true, false, true}, {}, {}};
  CHECK(sum_of_units(*find(choice).direction) == Eigen::Vector3d(1, 0, 1));
  CHECK(unit_vectors(*find(choice).direction).size() == 2);
}

TEST_CASE("an axis runs along a direction or through two points", "[core][conditions]") {
  const Axis spin = std::get<Axis>(*find(about("spin")).direction);
  CHECK(spin.direction == Eigen::Vector3d::UnitZ());
  CHECK(spin.offset_of({3, 4, 7}) == Eigen::Vector3d(3, 4, 0));
  const Axis through = std::get<Axis>(*find(about("rightward")).direction);
  CHECK(through.direction == Eigen::Vector3d::UnitX());
  CHECK(through.offset_of({3, 4, 7}) == Eigen::Vector3d(0, 4, 7));
  CHECK(find(about("spinn")).messages == "error: there is no axis 'spinn'; did you mean 'spin'?\n");
  CHECK_FALSE(find(about("none")).direction);
}

TEST_CASE("turning keeps the distance from the axis, counter-clockwise", "[core][conditions]") {
  const Axis axis;
  const Eigen::Vector3d offset(2, 0, 0);
  CHECK((offset + axis.turn(offset, 1.0, -1.0)).isApprox(Eigen::Vector3d(0, 2, 0)));
  const double angle = 1e-9;
  const Eigen::Vector3d change = axis.turn(offset, std::sin(angle), -2.0 * std::pow(std::sin(angle / 2), 2));
  CHECK(change.x() == Approx(-1e-18));  // it would be lost in 2 cos(angle) - 2
}

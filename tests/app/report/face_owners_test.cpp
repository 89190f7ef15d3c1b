// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/face_owners.hpp"

#include <algorithm>

#include "core/base/errors.hpp"
#include "core/definition/simulation.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"
#include "support/report_region.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two cubes in a row along x that share a side, of which the joint is the side set "joint" (of the first),
/// and the top of the first "top".
Mesh joined_cubes() {
  return MeshBuilder()
      .add_hexes({.id = 1, .name = "left"})
      .add_hexes({.id = 2, .name = "right", .origin = {1, 0, 0}})
      .add_side_set(3, "joint", std::vector<ElementSide>{ElementSide({0}, 2)})
      .add_side_set(4, "top", std::vector<ElementSide>{ElementSide({0}, 6)})
      .build();
}

std::string contact_with(const std::string& lines) { return "begin contact definition\n" + lines + "end"; }

ReportFace filled(FaceOwners& owners, ElementSide side, std::uint32_t shown_from = 0) {
  ReportFace face;
  face.element = side.element();
  face.side = side.side();
  face.shown_from = shown_from;
  owners.fill(false, face);
  return face;
}

}  // namespace

TEST_CASE("faces of contact are those outside and those in side sets", "[app][report]") {
  const Mesh mesh = joined_cubes();
  const SimulationDefinition deck =
      deck_of_region(contact_with("contact surface patch contains top joint\nskin all blocks = on\n"));
  const FaceOwners owners({deck, region_of(deck)}, mesh);
  CHECK(owners.names() == std::vector<std::string>{"patch", "left", "right"});
  const std::vector<ElementSide> faces = owners.faces();
  CHECK(faces.size() == 11);  // 10 outside and the joint
  CHECK(std::is_sorted(faces.begin(), faces.end()));
  CHECK(std::ranges::count(faces, ElementSide({0}, 2)) == 1);
}

TEST_CASE("a face has its owner and what was claimed in vain", "[app][report]") {
  const Mesh mesh = joined_cubes();
  const SimulationDefinition deck =
      deck_of_region(contact_with("contact surface patch contains top\nskin all blocks = on\n"));
  FaceOwners owners({deck, region_of(deck)}, mesh);
  const ReportFace top = filled(owners, ElementSide({0}, 6)), bottom = filled(owners, ElementSide({0}, 5));
  CHECK(top.owner == 1);  // patch, counted from 1
  CHECK(bottom.owner == 2);
  CHECK(bottom.claims == 0);
  REQUIRE(top.claims == 1);
  using Lost = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  CHECK(owners.lost().at(0).empty());
  CHECK(owners.lost().at(1) == Lost{{1, 0}});  // left lost it to patch
  CHECK(filled(owners, ElementSide({0}, 6)).claims == 1);
  CHECK(owners.lost().size() == 2);
}

TEST_CASE("a face inside has no owner until deaths expose it", "[app][report]") {
  const Mesh mesh = joined_cubes();
  const SimulationDefinition deck = deck_of_region(contact_with("skin all blocks = on\n"));
  FaceOwners owners({deck, region_of(deck)}, mesh);
  CHECK(filled(owners, ElementSide({1}, 4)).owner == 0);
  CHECK(filled(owners, ElementSide({1}, 4), 3).owner == 2);
}

TEST_CASE("names that the mesh does not have are refused", "[app][report]") {
  const Mesh mesh = joined_cubes();
  const SimulationDefinition deck = deck_of_region(contact_with("contact surface patch contains none\n"));
  CHECK_THROWS_AS(FaceOwners({deck, region_of(deck)}, mesh), DeckError);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/skin_change.hpp"

#include <algorithm>
#include <iterator>
#include <random>

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"
#include "support/slow_skin.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Three blocks of hexahedra that share faces, shells on one, tetrahedra and pyramids beside them.
Mesh mixed_mesh() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 3, 2}, .size = {2, 3, 2}});
  b.add_hexes({.id = 2, .cells = {2, 3, 1}, .origin = {2, 0, 0}, .size = {2, 3, 1}});
  b.add_hexes({.id = 3, .cells = {2, 3, 1}, .origin = {2, 0, 1}, .size = {2, 3, 1}});
  b.add_shells({.id = 4, .cells = {3, 3}, .origin = {0, 0, 2}, .u = {3, 0, 0}, .v = {0, 3, 0}});
  b.add_tets({.id = 5, .cells = {2, 1, 1}, .origin = {0, 3, 0}, .size = {2, 1, 1}}, 5);
  b.add_pyramids({.id = 6, .cells = {2, 1, 1}, .origin = {2, 3, 0}, .size = {2, 1, 1}});
  return b.build();
}

/// Takes a change over into a skin, of which it must be one.
void apply(const SkinChange& change, Skin& skin) {
  REQUIRE(std::ranges::includes(skin.exterior, change.removed));
  std::vector<ElementSide> kept, all;
  std::ranges::set_difference(skin.exterior, change.removed, std::back_inserter(kept));
  std::ranges::merge(kept, change.exposed, std::back_inserter(all));
  skin.exterior = all;
  for (std::size_t b = 0; b < skin.in_between.size(); ++b)
    skin.in_between[b] += static_cast<std::uint32_t>(change.in_between[b]);
}

}  // namespace

TEST_CASE("the skin less what dies is the skin of the others, death after death", "[core][skin]") {
  const Mesh mesh = mixed_mesh();
  const NodeElements elements(mesh);
  const FaceGroups faces(mesh, elements);
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> present(mesh.n_elements());
    for (auto& mark : present) mark = random() % 5 != 0;
    Skin skin = make_skin(mesh, present);
    for (int round = 0; round < 6; ++round) {
      std::vector<ElementIndex> dead;
      for (std::uint32_t i = 0; i < mesh.n_elements(); ++i) {
        if (random() % 5 == 0) dead.push_back({i});
      }
      apply(find_skin_change(faces, present, dead), skin);
      for (const ElementIndex element : dead) present[element.value] = 0;
      const Skin slow = make_slow_skin(mesh, present);
      REQUIRE(skin.exterior == slow.exterior);
      REQUIRE(skin.in_between == slow.in_between);
    }
  }
}

TEST_CASE("a hexahedron that dies exposes the faces of its neighbours", "[core][skin]") {
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1, .cells = {3, 1, 1}}).build();
  const NodeElements elements(mesh);
  const FaceGroups faces(mesh, elements);
  const std::vector<std::uint8_t> present{1, 1, 1};
  const ElementIndex middle{1};
  const SkinChange change = find_skin_change(faces, present, std::span(&middle, 1));
  CHECK(change.exposed == std::vector<ElementSide>{{{0}, 2}, {{2}, 4}});
  CHECK(change.removed == std::vector<ElementSide>{{middle, 1}, {middle, 3}, {middle, 5}, {middle, 6}});
}

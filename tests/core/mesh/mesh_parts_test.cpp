// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/mesh_parts.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using test::MeshBuilder;

TEST_CASE("sets are added to what a mesh has, with ids of their own", "[core][mesh]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 7, .name = "cube"}).add_node_set(4, "tip", std::vector<std::uint32_t>{0});
  builder.add_side_set(3, "end", std::vector<ElementSide>{{{0}, 2}});
  builder.set_node_ids({11, 12, 13, 14, 15, 16, 17, 18});
  const Mesh mesh = builder.build();
  const std::vector<NodeSet> more{{0, "contact_feet", {{1}, {2}}, {}}};
  const std::vector<SideSet> sides{{0, "top", {{{0}, 6}}, {}}};
  MeshParts parts = parts_of(mesh);
  add_sets(sides, more, parts);
  const Mesh with(std::move(parts));
  REQUIRE(with.node_sets().size() == 2);
  CHECK(with.node_sets()[1].id == 5);
  CHECK(with.node_sets()[1].nodes == more[0].nodes);
  CHECK(with.name({EntityKind::node_set, 1}) == "contact_feet");
  CHECK(with.node_id({3}) == 14);
  CHECK(with.coordinates() == mesh.coordinates());
  REQUIRE(with.side_sets().size() == 2);
  CHECK(with.side_sets()[1].id == 4);
  CHECK(with.side_sets()[1].sides == sides[0].sides);
  CHECK(with.names(EntityKind::block) == mesh.names(EntityKind::block));
}

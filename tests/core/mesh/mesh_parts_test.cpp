// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/mesh_parts.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using test::MeshBuilder;

TEST_CASE("node sets are added to what a mesh has, with ids of their own", "[core][mesh]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 7, .name = "cube"}).add_node_set(4, "tip", std::vector<std::uint32_t>{0});
  builder.add_side_set(3, "end", std::vector<ElementSide>{{{0}, 2}});
  builder.set_node_ids({11, 12, 13, 14, 15, 16, 17, 18});
  const Mesh mesh = builder.build();
  const std::vector<NodeSet> more{{0, "contact_feet", {{1}, {2}}, {}}};
  const Mesh with = with_node_sets(mesh, more);
  REQUIRE(with.node_sets().size() == 2);
  CHECK(with.node_sets()[1].id == 5);
  CHECK(with.node_sets()[1].nodes == more[0].nodes);
  CHECK(with.name({EntityKind::node_set, 1}) == "contact_feet");
  CHECK(with.node_id({3}) == 14);
  CHECK(with.coordinates() == mesh.coordinates());
  CHECK(with.names(EntityKind::side_set) == mesh.names(EntityKind::side_set));
  CHECK(with.names(EntityKind::block) == mesh.names(EntityKind::block));
}

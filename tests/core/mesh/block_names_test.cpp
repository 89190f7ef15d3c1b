// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/block_names.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using test::MeshBuilder;

TEST_CASE("a block goes by its names, those of its assemblies and aliases of either", "[core][mesh]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 3, .name = "lid"}).add_hexes({.id = 7, .origin = {2, 0, 0}});
  builder.add_node_set(1, "rim", std::vector<std::uint32_t>{0});
  builder.add_assembly(1, "half", EntityKind::block, {7});
  builder.add_assembly(2, "", EntityKind::assembly, {1});
  builder.add_assembly(3, "rims", EntityKind::node_set, {1});
  const Mesh mesh = builder.build();
  const std::vector<MeshAlias> aliases{{{"block_3", {}}, {"cover", {}}},
                                       {{"half", {}}, {"part", {}}},
                                       {{"rim", {}}, {"edge", {}}},
                                       {{"none", {}}, {"gone", {}}}};
  const auto names = find_block_names(mesh, aliases);
  REQUIRE(names.size() == 2);
  CHECK(names[0] == std::vector<std::string>{"lid", "block_3", "cover"});
  CHECK(names[1] == std::vector<std::string>{"block_7", "block_7", "half", "assembly_1", "assembly_2",
                                             "assembly_2", "part"});
  CHECK(find_block_names(Mesh(), aliases).empty());
}

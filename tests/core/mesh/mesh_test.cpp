// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/mesh.hpp"

#include <numeric>
#include <random>

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using test::MeshBuilder;

namespace {

constexpr auto block = EntityKind::block;
constexpr auto side_set = EntityKind::side_set;
constexpr auto node_set = EntityKind::node_set;
constexpr auto assembly = EntityKind::assembly;

}  // namespace

TEST_CASE("an empty mesh has nothing and finds nothing", "[core][mesh]") {
  const Mesh mesh;
  CHECK(mesh.n_nodes() == 0);
  CHECK(mesh.n_elements() == 0);
  CHECK(mesh.find("block_1").empty());
  CHECK(!mesh.find_element(1));
}

TEST_CASE("a name means one entity of every kind that bears it, case and blanks ignored", "[core][mesh]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 10, .name = "My Block"}).add_hexes({.id = 20, .origin = {1, 0, 0}});
  builder.add_side_set(3, "my_block", std::vector<ElementSide>{})
      .add_node_set(4, "tip", std::vector<std::uint32_t>{});
  builder.add_assembly(10, "all", block, {10, 20});
  const Mesh mesh = builder.build();
  CHECK(mesh.find("MY_BLOCK") == std::vector<Entity>{{block, 0}, {side_set, 0}});
  CHECK(mesh.find("Tip") == std::vector<Entity>{{node_set, 0}});
  CHECK(mesh.find("nowhere").empty());
  CHECK(mesh.find(side_set, "my block") == 0u);
  CHECK(!mesh.find(node_set, "my block"));
}

TEST_CASE("default names always work", "[core][mesh]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 10, .name = "named"}).add_hexes({.id = 0, .origin = {1, 0, 0}});
  builder.add_side_set(3, "", std::vector<ElementSide>{}).add_node_set(4, "n", std::vector<std::uint32_t>{});
  builder.add_assembly(10, "all", block, {10});
  const Mesh mesh = builder.build();
  CHECK(mesh.find(block, "Block_10") == 0u);
  CHECK(mesh.find(block, "block 0") == 1u);
  CHECK(mesh.find(side_set, "surface_3") == 0u);
  CHECK(mesh.find(side_set, "SIDESET_3") == 0u);
  CHECK(mesh.find(node_set, "nodelist_4") == 0u);
  CHECK(mesh.find(node_set, "nodeset_4") == 0u);
  CHECK(mesh.find(assembly, "assembly_10") == 0u);
  CHECK(!mesh.find(block, "block_010"));
  CHECK(!mesh.find(block, "block_99999999999999999999999"));
  CHECK(!mesh.find(block, "block_"));
  CHECK(!mesh.find(side_set, "block_10"));
}

TEST_CASE("a stored default name never overrides the id", "[core][mesh]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 9, .name = "block_7"}).add_hexes({.id = 7, .name = "Block_7"});
  builder.add_hexes({.id = 8, .name = "block_007"});
  builder.add_side_set(1, "block_7", std::vector<ElementSide>{})
      .add_side_set(2, "sideset_1", std::vector<ElementSide>{});
  const Mesh mesh = builder.build();
  CHECK(mesh.find(block, "block_7") == 1u);
  CHECK(mesh.find(block, "block_9") == 0u);
  CHECK(mesh.find(block, "block_007") == 2u);
  CHECK(mesh.find(side_set, "block_7") == 0u);
  CHECK(mesh.find(side_set, "sideset_1") == 0u);
  CHECK(mesh.name({block, 0}) == "block_9");
  CHECK(mesh.names(block) == std::vector<std::string>{"block_9", "Block_7", "block_007"});
  CHECK(mesh.names(side_set) == std::vector<std::string>{"block_7", "surface_2"});
}

TEST_CASE("without maps ids count from one", "[core][mesh]") {
  const Mesh mesh = MeshBuilder().add_hexes({.cells = {2, 1, 1}}).build();
  CHECK(mesh.node_id({0}) == 1);
  CHECK(mesh.find_node(12) == NodeIndex{11});
  CHECK(!mesh.find_node(13));
  CHECK(!mesh.find_node(0));
  CHECK(!mesh.find_element(-5));
  CHECK(mesh.find_element(2) == ElementIndex{1});
}

TEST_CASE("every id of a map is found at its position", "[core][mesh]") {
  std::vector<std::int64_t> ids(12);
  const std::string kind = GENERATE("counting", "increasing", "shuffled", "sparse");
  CAPTURE(kind);
  std::iota(ids.begin(), ids.end(), 1);
  if (kind != "counting") ids.back() = 40;
  if (kind == "sparse") ids[5] = std::numeric_limits<std::int64_t>::max();
  if (kind != "counting" && kind != "increasing") std::shuffle(ids.begin(), ids.end(), std::mt19937(1));
  const Mesh mesh = MeshBuilder().add_hexes({.cells = {2, 1, 1}}).set_node_ids(ids).build();
  for (std::uint32_t n = 0; n < 12; ++n) {
    CHECK(mesh.node_id({n}) == ids[n]);
    CHECK(mesh.find_node(ids[n]) == NodeIndex{n});
  }
  for (std::int64_t absent :
       {std::numeric_limits<std::int64_t>::min(), std::int64_t{0}, std::int64_t{39}, std::int64_t{1000}}) {
    CHECK(!mesh.find_node(absent));
  }
}

TEST_CASE("of a repeated id the first position is found", "[core][mesh]") {
  const std::int64_t far = GENERATE(std::int64_t{9}, std::int64_t{1} << 40);
  const Mesh mesh = MeshBuilder().add_hexes({.cells = {4, 1, 1}}).set_element_ids({7, far, 7, far}).build();
  CHECK(mesh.find_element(7) == ElementIndex{0});
  CHECK(mesh.find_element(far) == ElementIndex{1});
  const std::vector<std::int64_t> ids{7, far, 7, far};
  CHECK(IdLookup(ids).first_repeat() == 2u);
}

TEST_CASE("an element's block is found past empty blocks", "[core][mesh]") {
  MeshBuilder builder;
  builder.add_block(1, "", Shape::null, {}).add_hexes({.id = 2, .cells = {2, 1, 1}});
  builder.add_block(3, "", Shape::null, {}).add_tets({.id = 4}).add_block(5, "", Shape::null, {});
  const Mesh mesh = builder.build();
  CHECK(mesh.n_elements() == 8);
  CHECK(mesh.block_of({0}) == 1);
  CHECK(mesh.block_of({1}) == 1);
  CHECK(mesh.block_of({2}) == 3);
  CHECK(mesh.block_of({7}) == 3);
  CHECK(mesh.element_nodes({1}).size() == 8);
  CHECK(mesh.element_nodes({2}).size() == 4);
}

TEST_CASE("side nodes follow the side table and repeat a triangle's last corner", "[core][mesh]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 1}).add_tets({.id = 2, .origin = {5, 0, 0}}).add_spheres(3, "", {{9, 9, 9}});
  const Mesh mesh = builder.build();
  // Nodes of the cell by x, then y, then z; side 6 is the top.
  CHECK(mesh.side_nodes({{0}, 6}) == std::array<NodeIndex, 4>{{{4}, {5}, {7}, {6}}});
  const auto tet = mesh.element_nodes({1});
  CHECK(mesh.side_nodes({{1}, 1}) == std::array{tet[0], tet[1], tet[3], tet[3]});
  const NodeIndex centre = mesh.element_nodes({7})[0];
  CHECK(mesh.side_nodes({{7}, 1}) == std::array{centre, centre, centre, centre});
}

TEST_CASE("an assembly opens its nested ones in order of first mention", "[core][mesh]") {
  MeshBuilder builder;
  for (std::int64_t id : {1, 2, 3}) builder.add_hexes({.id = id, .origin = {double(id), 0, 0}});
  builder.add_side_set(8, "", std::vector<ElementSide>{});
  builder.add_assembly(10, "", block, {3, 1, 3})
      .add_assembly(20, "", side_set, {8})
      .add_assembly(30, "", block, {1, 2});
  builder.add_assembly(40, "", assembly, {20, 10, 30, 10});
  const Mesh mesh = builder.build();
  CHECK(mesh.members(0) == std::vector<Entity>{{block, 2}, {block, 0}});
  CHECK(mesh.members(3) == std::vector<Entity>{{side_set, 0}, {block, 2}, {block, 0}, {block, 1}});
}

TEST_CASE("assemblies that hold themselves or kinds we do not use end quietly", "[core][mesh]") {
  MeshParts parts;
  parts.assemblies.push_back({1, "a", assembly, {1}});
  parts.assemblies.push_back({2, "b", assembly, {0, 2}});
  parts.assemblies.push_back({3, "blobs", std::nullopt, {}});
  const Mesh mesh(parts);
  CHECK(mesh.members(0).empty());
  CHECK(mesh.members(2).empty());
}

TEST_CASE("a nest deeper than the call stack opens", "[core][mesh]") {
  MeshParts parts;
  constexpr std::uint32_t n = 300000;
  for (std::uint32_t i = 0; i < n; ++i) parts.assemblies.push_back({i, "", assembly, {i + 1}});
  parts.assemblies.push_back({n, "", node_set, {0}});
  parts.node_sets.push_back({1, "", {}, {}});
  CHECK(Mesh(parts).members(0) == std::vector<Entity>{{node_set, 0}});
}

TEST_CASE("the builder shares nodes only among boxes that want it", "[core][mesh]") {
  CHECK(MeshBuilder().add_hexes({.id = 1}).add_hexes({.id = 2, .origin = {1, 0, 0}}).build().n_nodes() == 12);
  CHECK(MeshBuilder()
            .add_hexes({.id = 1})
            .add_hexes({.id = 2, .origin = {1, 0, 0}, .share_nodes = false})
            .build()
            .n_nodes() == 16);
  CHECK(MeshBuilder().add_bars({.cells = 3}).add_beams({.id = 2, .cells = 3}).build().n_nodes() == 4);
  CHECK(MeshBuilder().add_bars({.cells = 3, .share_nodes = false}).build().n_nodes() == 4);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/resolve_surfaces.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"

// CONTACT NODE SET. Nodes of a brick are numbered with x fastest and z slowest.

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// 2 x 1 x 1 hexahedra (nodes 1 to 12) with a shell on the end x = 2 (nodes 3, 6, 9, 12) and a beam from its
/// corner 12 to the new node 13. nodelist_1: nodes 1, 2, 3; nodelist_2: 3, 4.
MeshBuilder bar_with_tail() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 1, 1}, .size = {2, 1, 1}});
  b.add_shells({.id = 2, .origin = {2, 0, 0}, .u = {0, 1, 0}, .v = {0, 0, 1}});
  b.add_beams({.id = 3, .from = {2, 1, 1}, .to = {3, 1, 1}});
  b.add_side_set(1, "tops", {{{0}, 6}, {{1}, 6}});
  b.add_side_set(2, "left", {{{0}, 4}});
  b.add_node_set(1, "", {2, 0, 1, 1});
  b.add_node_set(2, "", {3, 2});
  b.add_assembly(5, "sets", EntityKind::node_set, {1, 2});
  b.add_assembly(6, "parts", EntityKind::block, {2, 3});
  return b;
}

}  // namespace

TEST_CASE("a node set gives its nodes, each once", "[contact][nodes]") {
  const Mesh mesh = bar_with_tail().build();
  const auto result = resolve(mesh, "contact node set n contains nodelist_1\n");
  REQUIRE(result.messages.empty());
  CHECK(describe(mesh, result) == "n |  |  | 1 2 3 | \n");
  CHECK(result["n"].kind == SurfaceKind::node);
  CHECK(result["n"].command == "CONTACT NODE SET");
  CHECK(result.warnings.empty());
}

TEST_CASE("all nodes of a brick make a surface of nodes without faces", "[contact][nodes]") {
  // 2 x 2 x 3 cells have 3 * 3 * 4 = 36 nodes, 34 of them outside.
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 3}});
  b.add_node_set(1, "", [](const Eigen::Vector3d&) { return true; });
  const Mesh mesh = b.build();
  for (const std::string part : {"nodelist_1", "block_1"}) {
    const auto result = resolve(mesh, "contact node set n contains " + part + "\n");
    CHECK(result["n"].nodes.size() == 36);
    CHECK(result["n"].faces.empty());
  }
}

TEST_CASE("side sets, blocks and assemblies give nodes and no lofts", "[contact][nodes]") {
  const Mesh mesh = bar_with_tail().build();
  const auto nodes_of = [&](const std::string& items) {
    const auto result = resolve(mesh, "contact node set n contains " + items + "\n");
    CHECK(result.messages.empty());
    CHECK(result["n"].lofted_elements.empty());
    return list_nodes(mesh, result["n"]);
  };
  CHECK(nodes_of("left") == "1 4 7 10");
  CHECK(nodes_of("block_3") == "12 13");
  CHECK(nodes_of("parts") == "3 6 9 12 13");
  CHECK(nodes_of("sets") == "1 2 3 4");
  CHECK(nodes_of("block_3, left nodelist_2") == "1 3 4 7 10 12 13");
}

TEST_CASE("a node belongs to the first surface of nodes, whatever faces own", "[contact][nodes]") {
  const Mesh mesh = bar_with_tail().build();
  const auto result = resolve(mesh,
                              "contact surface faces contains block_1\n"
                              "contact node set a contains nodelist_1\n"
                              "contact node set b contains nodelist_2\n"
                              "contact node set c contains nodelist_1\n"
                              "contact surface top contains tops\n");
  CHECK(list_nodes(mesh, result["a"]) == "1 2 3");
  CHECK(list_nodes(mesh, result["b"]) == "4");
  CHECK(list_lost(result, result["b"]) == "a 1 nodes");
  CHECK(result["faces"].faces.size() == 10);
  CHECK(list_warnings(result) ==
        "surface-overlap, line 3, b, 1: surface 'b': 1 node already in surface 'a'\n"
        "surface-overlap, line 4, c, 3: surface 'c': 3 nodes already in surface 'a'\n"
        "surface-empty, line 4, c, 0: surface 'c' owns nothing and takes no part in contact\n"
        "surface-overlap, line 5, top, 2: surface 'top': 2 faces already in surface 'faces'\n"
        "surface-empty, line 5, top, 0: surface 'top' owns nothing and takes no part in contact\n");
}

TEST_CASE("dead elements give no nodes, node sets stay as they are", "[contact][nodes][death]") {
  const Mesh mesh = bar_with_tail().build();
  const std::string lines =
      "contact node set a contains block_1\n"
      "contact node set b contains left nodelist_2\n";
  // Element 1 dies: block_1 keeps the nodes of element 2, the side set loses its only side.
  const auto result = resolve(mesh, lines, all_but(mesh, {1}));
  CHECK(list_nodes(mesh, result["a"]) == "2 3 5 6 8 9 11 12");
  CHECK(list_nodes(mesh, result["b"]) == "4");
  CHECK(list_lost(result, result["b"]) == "a 1 nodes");
}

TEST_CASE("a side set of shell edges gives nodes", "[contact][nodes]") {
  MeshBuilder b = bar_with_tail();
  b.add_side_set(9, "edge", {{{2}, 3}});  // element 3, the shell: its first edge, from 3 to 6
  const Mesh mesh = b.build();
  const auto result = resolve(mesh, "contact node set n contains edge\n");
  CHECK(result.messages.empty());
  CHECK(list_nodes(mesh, result["n"]) == "3 6");
}

TEST_CASE("node ids are the user's", "[contact][nodes]") {
  MeshBuilder b;
  b.add_beams({.id = 1, .cells = 2});
  b.set_node_ids({30, 10, 20});
  const Mesh mesh = b.build();
  const auto result = resolve(mesh, "contact node set n contains block_1\n");
  CHECK(list_nodes(mesh, result["n"]) == "30 10 20");
}

// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_sets.hpp"

#include "io/exodus/sample_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

// Side set 1 of the two hexes with this many distribution factors.
Mesh with_factors(std::size_t n) {
  MeshParts parts = two_hexes().parts();
  parts.side_sets[0].distribution_factors.assign(n, 1.0);
  return Mesh(parts);
}

const auto nothing = [](ExodusEditor&) {};

}  // namespace

TEST_CASE("members of sets must exist", "[io][sets]") {
  const Mesh mesh = two_hexes().build();
  CHECK(refusal(mesh, [](auto& file) { file.set_value("node_ns1", 3, 13); }) ==
        "node set 100 (fixed): entry 4: node_ns1 holds 13, which is not in 1 to 12");
  CHECK(refusal(mesh, [](auto& file) { file.set_value("elem_ss1", 1, 3); }) ==
        "side set 1 (top): entry 2: elem_ss1 holds 3, which is not in 1 to 2");
  CHECK(refusal(mesh, [](auto& file) { file.set_value("side_ss1", 0, 0); }) ==
        "side set 1 (top): entry 1: side_ss1 holds 0, which is not in 1 to 2147483647");
}

TEST_CASE("side numbers must suit the element's shape", "[io][sets]") {
  CHECK(refusal(two_hexes().build(), [](auto& file) { file.set_value("side_ss1", 0, 7); }) ==
        "side set 1 (top): entry 1: element 2 of block 20 (upper) has no side 7 (type 'HEX8', sides 1 to 6)");
  MeshBuilder builder;
  builder.add_hexes({.id = 1}).add_tets({.id = 2, .origin = {2, 0, 0}});
  builder.add_side_set(1, "", std::vector<ElementSide>{{{0}, 5}, {{1}, 4}});
  CHECK(refusal(builder.build(), nothing).empty());
  CHECK(refusal(builder.build(), [](auto& file) { file.set_value("side_ss1", 1, 5); }) ==
        "side set 1: entry 2: element 2 of block 2 has no side 5 (type 'TETRA4', sides 1 to 4)");
}

TEST_CASE("sides of an unknown element type are kept up to 8", "[io][sets]") {
  const auto with_side = [](double side) {
    return [side](ExodusEditor& file) {
      file.set_attribute("connect2", "elem_type", "BEX_HEX").set_value("side_ss1", 0, side);
    };
  };
  CHECK(reread(two_hexes().build(), with_side(8)).side_sets()[0].sides[0] == ElementSide({1}, 8));
  CHECK(refusal(two_hexes().build(), with_side(9)) ==
        "side set 1 (top): entry 1: element 2 of block 20 (upper) has no side 9 (type 'BEX_HEX', sides 1 to "
        "8)");
}

TEST_CASE("elements and sides of a set must pair up", "[io][sets]") {
  CHECK(refusal(two_hexes().build(), [](auto& file) {
          file.rename_variable("side_ss1", "old").add_integers("side_ss1", {"num_dim"}, {1, 1, 1});
        }) == "side set 1 (top): 2 elements but 3 sides");
}

TEST_CASE("sides may repeat and stand in any order", "[io][sets]") {
  MeshBuilder builder = sample_mesh();
  const std::vector<ElementSide> sides{{{9}, 4}, {{0}, 6}, {{9}, 4}, {{10}, 1}, {{0}, 1}, {{13}, 6}};
  builder.add_side_set(77, "mixed", sides);
  CHECK(reread(builder.build(), nothing).side_sets()[2].sides == sides);
}

TEST_CASE("distribution factors are one per node of each side, one per side, or none", "[io][sets]") {
  for (std::size_t n : {0, 2, 8}) {
    CHECK(warnings_of(with_factors(n), nothing).empty());
    CHECK(reread(with_factors(n), nothing).side_sets()[0].distribution_factors.size() == n);
  }
  CHECK(warnings_of(with_factors(7), nothing) ==
        "warning: side set 1 (top): 7 distribution factors where 8 belong; they are left out "
        "[mesh-distribution-factors]\n");
  CHECK(reread(with_factors(7), nothing).side_sets()[0].distribution_factors.empty());
}

TEST_CASE("mid nodes of quadratic sides have distribution factors too", "[io][sets]") {
  struct Case {
    Shape shape;
    int side;
    std::size_t n_factors;
  };
  const Case c =
      GENERATE(Case{Shape::hex20, 1, 8}, Case{Shape::hex27, 6, 9}, Case{Shape::tet10, 4, 6},
               Case{Shape::wedge15, 1, 8}, Case{Shape::wedge15, 5, 6}, Case{Shape::pyramid13, 5, 8},
               Case{Shape::shell9, 2, 9}, Case{Shape::shell8, 3, 3}, Case{Shape::quad4, 1, 2},
               Case{Shape::bar3, 1, 1}, Case{Shape::sphere, 1, 1}, Case{Shape::tet4, 2, 3});
  MeshBuilder builder;
  std::vector<std::uint32_t> nodes;
  for (int n = 0; n < topology(c.shape).n_nodes; ++n)
    nodes.push_back(builder.add_node({double(n), 0, 0}).value);
  builder.add_block(1, "", c.shape, nodes).add_side_set(1, "", std::vector<ElementSide>{{{0}, c.side}});
  MeshParts parts = builder.parts();
  parts.side_sets[0].distribution_factors.assign(c.n_factors, 2.0);
  INFO(topology(c.shape).name);
  CHECK(warnings_of(Mesh(parts), nothing).empty());
  parts.side_sets[0].distribution_factors.push_back(2.0);
  CHECK(!warnings_of(Mesh(parts), nothing).empty());
}

TEST_CASE("distribution factors of node sets are one per node", "[io][sets]") {
  const auto change = [](ExodusEditor& file) { file.add_reals("dist_fact_ns1", {"num_dim"}, {1, 2, 3}); };
  CHECK(warnings_of(two_hexes().build(), change) ==
        "warning: node set 100 (fixed): 3 distribution factors where 4 belong; they are left out "
        "[mesh-distribution-factors]\n");
  CHECK(reread(two_hexes().build(),
               [](auto& file) {
                 file.add_reals("dist_fact_ns1", {"num_nod_ns1"}, {1, 2, 3, 4});
               })
            .node_sets()[0]
            .distribution_factors == std::vector<double>{1, 2, 3, 4});
}

TEST_CASE("a set with status 0 is empty whatever is stored", "[io][sets]") {
  const Mesh found = reread(two_hexes().build(), [](auto& file) {
    file.set_value("ss_status", 0, 0).set_value("ns_status", 0, 0);
  });
  CHECK(found.side_sets()[0].sides.empty());
  CHECK(found.node_sets()[0].nodes.empty());
}

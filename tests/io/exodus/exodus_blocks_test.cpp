// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_blocks.hpp"

#include "core/base/errors.hpp"
#include "core/mesh/element_checks.hpp"
#include "io/exodus/sample_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

TEST_CASE("every shape comes back from its own type name", "[io][blocks]") {
  for (int i = 0; i < static_cast<int>(Shape::null); ++i) {
    const auto shape = static_cast<Shape>(i);
    MeshBuilder builder;
    std::vector<std::uint32_t> nodes;
    for (int n = 0; n < topology(shape).n_nodes; ++n)
      nodes.push_back(builder.add_node({double(n), 0, 0}).value);
    builder.add_block(1, "", shape, nodes);
    const Mesh found = reread(builder.build(), [](auto&) {});
    CHECK(topology(found.blocks()[0].shape).name == topology(shape).name);
    CHECK(found.blocks()[0].nodes.size() == nodes.size());
  }
}

TEST_CASE("nodes out of range are named by block, element and place", "[io][blocks]") {
  const double value = GENERATE(0.0, -3.0, 13.0);
  CHECK(refusal(sample_mesh().build(), [](auto& file) { file.set_value("connect2", 7, 1000); }) ==
        "block 7 (Upper Part): element 2 of the block: node 4 of 4 is 1000, but the mesh has nodes 1 to 27");
  CHECK(refusal(two_hexes().build(), [&](auto& file) { file.set_value("connect2", 7, value); }) ==
        "block 20 (upper): element 1 of the block: node 8 of 8 is " + std::to_string(int(value)) +
            ", but the mesh has nodes 1 to 12");
}

TEST_CASE("missing or mismatched connectivity is refused", "[io][blocks]") {
  const Mesh mesh = two_hexes().build();
  CHECK(refusal(mesh, [](auto& file) { file.rename_variable("connect2", "c"); }) ==
        "block 20 (upper): has 1 elements but no connectivity (variable connect2)");
  CHECK(refusal(mesh, [](auto& file) {
          file.rename_dimension("num_el_in_blk1", "n").add_dimension("num_el_in_blk1", 5);
        }) == "block 10 (lower): declares 5 elements, its connectivity has 1");
  CHECK(refusal(mesh, [](auto& file) {
          file.rename_dimension("num_elem", "n").add_dimension("num_elem", 3);
        }) == "its blocks have 2 elements, but num_elem says 3");
  CHECK(refusal(mesh, [](auto& file) { file.set_value("eb_status", 1, 0); }) ==
        "its blocks have 1 elements, but num_elem says 2");
}

TEST_CASE("a block of an unknown or missing type is an error only to who uses it", "[io][blocks]") {
  const bool is_missing = GENERATE(false, true);
  const Mesh found = reread(two_hexes().build(), [&](auto& file) {
    // Such a block's connectivity may hold anything.
    file.set_value("connect2", 0, 999);
    is_missing ? file.remove_attribute("connect2", "elem_type")
               : file.set_attribute("connect2", "elem_type", "BEX_HEX");
  });
  const ElementBlock& block = found.blocks()[1];
  CHECK(block.shape == Shape::unknown);
  CHECK(block.type_name == (is_missing ? "" : "BEX_HEX"));
  CHECK(block.n_elements == 1);
  CHECK(block.nodes_per_element == 8);
  CHECK(block.nodes.empty());
  const std::uint32_t first[] = {0}, second[] = {1};
  CHECK_NOTHROW(check_elements(found, first));
  CHECK_THROWS_WITH(
      check_elements(found, second),
      Contains(is_missing ? "upper: the file does not say what type of elements it has"
                          : "upper: its elements are of type 'BEX_HEX' with 8 nodes, which contactsim "
                            "does not know"));
}

TEST_CASE("polyhedra keep their count without a connectivity", "[io][blocks]") {
  const Mesh found = reread(two_hexes().build(), [](auto& file) {
    file.rename_variable("connect2", "c").add_integers("facconn2", {"num_el_blk"}, {1, 2});
  });
  CHECK(found.blocks()[1].shape == Shape::unknown);
  CHECK(found.blocks()[1].n_elements == 1);
}

TEST_CASE("degenerate elements are flagged on their block alone", "[io][blocks]") {
  const Mesh found = reread(two_hexes().build(), [](auto& file) { file.set_value("connect2", 0, 6); });
  CHECK(!found.blocks()[0].has_repeated_nodes);
  CHECK(found.blocks()[1].has_repeated_nodes);
}

TEST_CASE("a type name in any spelling is read", "[io][blocks]") {
  const Mesh found = reread(two_hexes().build(), [](auto& file) {
    file.set_attribute("connect1", "elem_type", "hex")
        .set_attribute("connect2", "elem_type", "HEXAHEDRON_8  ");
  });
  CHECK(found.blocks()[0].shape == Shape::hex8);
  CHECK(found.blocks()[1].shape == Shape::hex8);
  CHECK(found.blocks()[1].type_name == "HEXAHEDRON_8");
}

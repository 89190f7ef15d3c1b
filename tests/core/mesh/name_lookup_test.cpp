// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/name_lookup.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using contactsim::test::MeshBuilder;

namespace {

Mesh named_mesh() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .name = "Left Plate"});
  b.add_node_set(20, "corners", {0, 1});
  b.add_assembly(30, "pair", EntityKind::block, {1});
  return b.build();
}

/// What looking a name up as a block says about it.
std::string error_of(const std::string& name, const std::string& hint = "") {
  const Mesh mesh = named_mesh();
  Diagnostics diagnostics;
  NameLookup(mesh, {}, diagnostics, hint).find({name, {}}, {EntityKind::block}, "BLOCK");
  return messages(diagnostics);
}

}  // namespace

TEST_CASE("a name that is of no kind that is asked for is an error", "[core][mesh]") {
  CHECK(error_of("left_plate") == "");
  CHECK(error_of("left_plat") == "error: the mesh has no block 'left_plat'; did you mean 'Left Plate'?\n");
  CHECK(error_of("corners") == "error: 'corners' is a node set of the mesh, but BLOCK takes a block\n");
  CHECK(error_of("corners", "say NODE SET") ==
        "error: 'corners' is a node set of the mesh, but BLOCK takes a block; say NODE SET\n");
  CHECK(error_of("pair", "say NODE SET") ==
        "error: 'pair' is an assembly of the mesh, but BLOCK takes a block\n");
}

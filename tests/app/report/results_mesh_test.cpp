// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/results_mesh.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A cube with a side set, a node set and an assembly, and further blocks behind it.
MeshBuilder cube_with(const std::vector<std::string>& further) {
  MeshBuilder builder;
  builder.add_hexes({.id = 1, .name = "cube"});
  for (std::size_t i = 0; i < further.size(); ++i)
    builder.add_spheres(static_cast<std::int64_t>(i) + 2, further[i], {{0, 0, 9.0 + static_cast<double>(i)}});
  builder.add_side_set(3, "top", std::vector<ElementSide>{ElementSide({0}, 6)})
      .add_node_set(4, "foot", std::vector<std::uint32_t>{0, 1})
      .add_assembly(5, "all", EntityKind::block, {1});
  return builder;
}

Mesh read_back(const Mesh& mesh) {
  const TemporaryDirectory directory;
  write_exodus(directory.file("r.e"), mesh);
  Diagnostics warnings;
  return read_results_mesh(directory.file("r.e"), warnings);
}

}  // namespace

TEST_CASE("a block that a run added for its rigid bodies is left out, its nodes stay", "[app][report]") {
  const Mesh mesh = read_back(cube_with({"grain", "rigidbodyoutputpart"})
                                  .set_element_ids({11, 12, 13})
                                  .set_node_ids({1, 2, 3, 4, 5, 6, 7, 8, 90, 100})
                                  .build());
  REQUIRE(mesh.blocks().size() == 2);
  CHECK(mesh.blocks()[1].name == "grain");
  CHECK(mesh.n_elements() == 2);
  CHECK(mesh.element_id({1}) == 12);
  CHECK(mesh.n_nodes() == 10);
  CHECK(mesh.node_id({9}) == 100);
  CHECK(mesh.side_sets().size() == 1);
  CHECK(mesh.node_sets().size() == 1);
}

TEST_CASE("a mesh without such a block at its end is as it is read", "[app][report]") {
  CHECK(read_back(cube_with({}).build()).n_elements() == 1);
  CHECK(read_back(cube_with({"RigidBodyOutputPart", "grain"}).build()).blocks().size() == 3);
  Diagnostics warnings;
  CHECK_THROWS_AS(read_results_mesh("/no/such/r.e", warnings), FileError);
}

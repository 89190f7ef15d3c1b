// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/results_mesh.hpp"

#include "io/exodus/drafted_file.hpp"
#include "io/exodus/sample_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using Numbers = std::vector<double>;

DraftedFile with_mesh(const Mesh& mesh) {
  return DraftedFile([&](ExodusDraft& draft) { add_mesh(mesh, draft); });
}

}  // namespace

TEST_CASE("a block is written by its nodes, counted from 1, and attributes", "[io][results]") {
  const Mesh mesh = MeshBuilder()
                        .add_shells({.id = 4, .name = "sheet", .cells = {2, 1}})
                        .set_attributes(4, {"thickness"}, {0.5, 0.25})
                        .build();
  const DraftedFile drafted = with_mesh(mesh);
  const NetcdfFile file = drafted.open();
  CHECK(DraftedFile::numbers(file, "connect1").size() == 8);
  CHECK(DraftedFile::numbers(file, "connect1")[0] == mesh.blocks()[0].nodes[0].value + 1);
  CHECK(file.find_text(*file.find_variable("connect1"), "elem_type") == "SHELL4");
  CHECK(DraftedFile::numbers(file, "attrib1") == Numbers{0.5, 0.25});
  CHECK(DraftedFile::numbers(file, "eb_prop1") == Numbers{4});
  const Numbers x = DraftedFile::numbers(file, "coordx");
  for (std::size_t n = 0; n < x.size(); ++n)
    CHECK(x[n] == mesh.coordinates()(0, static_cast<Eigen::Index>(n)));
}

TEST_CASE("maps of ids are written where they tell something", "[io][results]") {
  MeshBuilder builder = two_hexes();
  CHECK_FALSE(with_mesh(builder.build()).open().find_variable("elem_num_map"));
  builder.set_element_ids({7, 5});
  const DraftedFile drafted = with_mesh(builder.build());
  const NetcdfFile file = drafted.open();
  CHECK(DraftedFile::numbers(file, "elem_num_map") == Numbers{7, 5});
  CHECK_FALSE(file.find_variable("node_num_map"));
  CHECK(make_element_map(builder.build()) == std::vector<std::int64_t>{7, 5});
  CHECK(make_node_map(builder.build()).back() == 12);
}

TEST_CASE("an empty block keeps its row and has no nodes", "[io][results]") {
  MeshParts parts = two_hexes().parts();
  ElementBlock empty;
  empty.id = 30;
  parts.blocks.push_back(empty);
  const DraftedFile drafted = with_mesh(Mesh(std::move(parts)));
  const NetcdfFile file = drafted.open();
  CHECK(DraftedFile::numbers(file, "eb_status") == Numbers{1, 1, 0});
  CHECK(DraftedFile::numbers(file, "eb_prop1") == Numbers{10, 20, 30});
  CHECK_FALSE(file.find_variable("connect3"));
}

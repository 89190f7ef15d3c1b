// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/msh_reader.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/replaced.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

const std::string names =
    "$PhysicalNames\n3\n1 4 \"edge\"\n2 5 \"top\"\n3 7 \"the column\"\n$EndPhysicalNames\n";
const std::string corners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 2\n1 0 2\n1 1 2\n0 1 2\n";

/// A hexahedron, its top and an edge of it in format 4.1; nodes 11 to 18.
std::string new_format() {
  return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + names +
         "$Entities\n0 1 1 1\n1 0 0 0 1 0 0 1 4 0\n6 0 0 2 1 1 2 1 5 0\n1 0 0 0 1 1 2 1 7 1 6\n$EndEntities\n"
         "$Nodes\n1 8 11 18\n3 1 0 8\n11\n12\n13\n14\n15\n16\n17\n18\n" +
         corners +
         "$EndNodes\n$Elements\n3 3 1 3\n1 1 1 1\n1 11 12\n2 6 3 1\n2 15 16 17 18\n3 1 5 1\n"
         "3 11 12 13 14 15 16 17 18\n$EndElements\n$Periodic\n0\n$EndPeriodic\n";
}

/// The same in format 2.2.
std::string old_format() {
  std::string nodes, line = corners;
  for (int id = 11; id <= 18; ++id) {
    const std::size_t end = line.find('\n');
    nodes += std::to_string(id) + " " + line.substr(0, end + 1);
    line.erase(0, end + 1);
  }
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + names + "$Nodes\n8\n" + nodes +
         "$EndNodes\n$Elements\n3\n1 1 2 4 1 11 12\n2 3 2 5 6 15 16 17 18\n"
         "3 5 2 7 1 11 12 13 14 15 16 17 18\n$EndElements\n";
}

DraftMesh read_msh_text(const std::string& text) {
  const TemporaryDirectory directory;
  write_bytes(directory.file("m.msh"), text);
  return read_msh(directory.file("m.msh"));
}

std::string msh_message(const std::string& text) {
  try {
    read_msh_text(text);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a mesh of Gmsh is the same in its formats 2.2 and 4.1", "[io][import]") {
  for (const std::string& text : {new_format(), old_format()}) {
    const DraftMesh mesh = read_msh_text(text);
    REQUIRE(mesh.groups.size() == 3);
    CHECK(mesh.node_ids.front() == 11);
    CHECK(mesh.coordinates.at(6) == Eigen::Vector3d(1, 1, 2));
    CHECK(mesh.groups[0].name == "edge");
    CHECK(mesh.groups[0].dimension == 1);
    CHECK(mesh.groups[1].id == 5);
    CHECK(mesh.groups[1].nodes == std::vector<NodeIndex>{{4}, {5}, {6}, {7}});
    CHECK(mesh.groups[2].name == "the column");
    CHECK(mesh.groups[2].shape == Shape::hex8);
    CHECK(mesh.groups[2].elements == std::vector<std::int64_t>{3});
  }
}

TEST_CASE("without physical groups the entities of the highest dimension are the groups", "[io][import]") {
  const std::string text =
      replaced(replaced(replaced(new_format(), "1 4 0\n", "0 0\n"), "1 5 0\n", "0 0\n"), "1 7 1 6", "0 1 6");
  const DraftMesh mesh = read_msh_text(text);
  REQUIRE(mesh.groups.size() == 1);
  CHECK(mesh.groups[0].id == 1);
  CHECK(mesh.groups[0].shape == Shape::hex8);
}

TEST_CASE("nodes of a ten-node tetrahedron are put in the order of Exodus", "[io][import]") {
  std::string nodes;
  for (int id = 1; id <= 10; ++id) nodes += std::to_string(id) + " 0 0 " + std::to_string(id) + "\n";
  const DraftMesh mesh =
      read_msh_text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n10\n" + nodes +
                    "$EndNodes\n$Elements\n1\n1 11 2 1 1 1 2 3 4 5 6 7 8 9 10\n$EndElements\n");
  // Gmsh: ... edges (2,3) and (1,3) last; Exodus the other way round.
  CHECK(mesh.groups.at(0).nodes.at(8).value == 9);
  CHECK(mesh.groups.at(0).nodes.at(9).value == 8);
}

TEST_CASE("what is wrong with a mesh of Gmsh is said with its line", "[io][import]") {
  CHECK_THAT(msh_message("solid x\n"), Contains("m.msh: line 1: expected $MeshFormat"));
  CHECK_THAT(msh_message(replaced(new_format(), "4.1 0 8", "4.1 1 8")),
             Contains("line 2: the mesh is binary"));
  CHECK_THAT(msh_message(replaced(new_format(), "4.1 0 8", "4 0 8")),
             Contains("format 4 is not read: save as 4.1"));
  CHECK_THAT(msh_message(replaced(new_format(), "2 15 16", "2 15 19")),
             Contains("element 2 has the node 19, which is not there"));
  CHECK_THAT(msh_message(replaced(new_format(), "3 1 5 1\n", "3 1 17 1\n")),
             Contains("elements of Gmsh's type 17 are not read"));
  CHECK_THAT(msh_message(replaced(new_format(), "1 7 1 6", "2 7 8 1 6")),
             Contains("in the physical groups 7 and 8"));
  CHECK_THAT(msh_message(replaced(new_format(), "\n12\n", "\n11\n")), Contains("node 11 is there twice"));
  CHECK_THAT(msh_message(replaced(new_format(), "1 1 2\n", "1 x 2\n")),
             Contains("expected a number, found 'x'"));
  CHECK_THAT(msh_message(new_format().substr(0, 250)), Contains("the file ends here"));
}

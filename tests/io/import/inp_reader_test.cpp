// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/inp_reader.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/replaced.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

const std::string cube_text =
    "** a cube and a sheet\n*Heading\n of the deck\n*NODE, NSET=All\n"
    "1, 0, 0, 0\n2, 1., 0, 0\n3, 1., 1., 0\n4, 0, 1., 0\n5, 0, 0, 1.\n6, 1., 0, 1.\n7, 1., 1., 1.\n8, 0, 1., "
    "1.\n"
    "9, 2., 0, 0\n10, 2., 1., 0\n*Element, type=C3D8R, elset=Solid\n 17, 1, 2, 3, 4, 5,\n 6, 7, 8\n"
    "*ELEMENT, TYPE=S4, ELSET=sheet\n18, 2, 9, 10, 3\n*NSET, NSET=low, GENERATE\n1, 4, 1\n*NSET, "
    "NSET=both\nlow, 9,\n"
    "*SURFACE, NAME=Top, TYPE=ELEMENT\nsolid, S2\n*Solid Section, elset=Solid, material=steel\n*STEP\n*END "
    "STEP\n";

DraftMesh read_inp_text(const std::string& text) {
  const TemporaryDirectory directory;
  write_bytes(directory.file("m.inp"), text);
  return read_inp(directory.file("m.inp"));
}

std::string inp_message(const std::string& text) {
  try {
    read_inp_text(text);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("blocks, sets and surfaces of an input file are read", "[io][import]") {
  const DraftMesh mesh = read_inp_text(cube_text);
  REQUIRE(mesh.groups.size() == 2);
  CHECK(mesh.groups[0].name == "Solid");
  CHECK(mesh.groups[0].shape == Shape::hex8);
  CHECK(mesh.groups[0].elements == std::vector<std::int64_t>{17});
  CHECK(mesh.groups[0].nodes.back().value == 7);
  CHECK(mesh.groups[1].shape == Shape::shell4);
  CHECK(mesh.groups[1].dimension == 2);
  REQUIRE(mesh.node_sets.size() == 3);
  CHECK(mesh.node_sets[0].name == "all");
  CHECK(mesh.node_sets[1].name == "both");
  CHECK(mesh.node_sets[1].nodes.size() == 5);
  REQUIRE(mesh.side_sets.size() == 1);
  CHECK(mesh.side_sets[0].name == "Top");
  CHECK(mesh.side_sets[0].faces.at(0) == DraftFace{{{4}, {7}, {6}, {5}}});
}

TEST_CASE("sets and surfaces that become nothing are named", "[io][import]") {
  CHECK(read_inp_text(cube_text).passed_over.empty());
  const DraftMesh mesh =
      read_inp_text(cube_text + "*ELSET, ELSET=Half\n17\n*SURFACE, NAME=n, TYPE=NODE\nlow\n");
  REQUIRE(mesh.passed_over.size() == 2);
  CHECK_THAT(mesh.passed_over[0], Contains("surface 'n': passed over"));
  CHECK_THAT(mesh.passed_over[1], Contains("ELSET 'half': passed over"));
}

TEST_CASE("what is wrong with an input file is said with its line", "[io][import]") {
  CHECK_THAT(inp_message(replaced(cube_text, "C3D8R", "C3D20")),
             Contains("line 15: elements of the type 'C3D20' are not read"));
  CHECK_THAT(inp_message(replaced(cube_text, "10, 3\n", "11, 3\n")),
             Contains("element 18 has the node 11, which is not there"));
  CHECK_THAT(inp_message(replaced(cube_text, "solid, S2", "solid, SPOS")),
             Contains("expected an element or an ELSET and a face"));
  CHECK_THAT(inp_message(replaced(cube_text, "solid, S2", "19, S2")), Contains("there is no element 19"));
  CHECK_THAT(inp_message(replaced(cube_text, "solid, S2", "sheet, S2")),
             Contains("element 18 has no face S2"));
  CHECK_THAT(inp_message(replaced(cube_text, "*STEP", "*INCLUDE, INPUT=more.inp")), Contains("more.inp"));
  CHECK_THAT(inp_message(replaced(cube_text, "2, 1., 0, 0", "1, 1., 0, 0")),
             Contains("node 1 is there twice"));
  CHECK_THAT(inp_message(replaced(cube_text, "1, 4, 1", "1, 4000000000000, 1")),
             Contains("are not the ids of a set"));
  CHECK_THAT(inp_message("*NODE\n1, 0, 0, 0\n"), Contains("no *NODE or no *ELEMENT"));
}

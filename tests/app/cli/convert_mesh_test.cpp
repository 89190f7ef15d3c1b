// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/convert_mesh.hpp"

#include "support/catch.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::ProgramDirectory;

TEST_CASE("a mesh of an input file is one that a deck runs on", "[app][mesh]") {
  const ProgramDirectory directory;
  directory.write("m.inp",
                  "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, "
                  "1\n8, 0, 1, 1\n"
                  "*ELEMENT, TYPE=C3D8, ELSET=cube\n5, 1, 2, 3, 4, 5, 6, 7, 8\n*SURFACE, NAME=top\n5, S2\n");
  const auto [code, out, err] = directory.run({"mesh", "m.inp", "m.g"});
  CHECK(err == "");
  CHECK(code == 0);
  CHECK_THAT(out,
             Contains("m.g: 8 nodes, 1 element\n") && Contains("volume 'cube': block 1 of HEX8, 1 element"));
  directory.write("m.i",
                  "begin contact definition\ncontact surface lid contains top\nskin all blocks = on\nend\n");
  const auto tables = directory.run({"m.i", "m.g", "--tables"});
  CHECK(tables.exit_code == 0);
  CHECK_THAT(tables.out, Contains("lid") && Contains("cube"));
}

TEST_CASE("a mesh of an unknown kind, or that is not there, is a file error", "[app][mesh]") {
  const ProgramDirectory directory;
  const auto stl = directory.run({"mesh", "m.stl", "m.g"});
  CHECK(stl.exit_code == 3);
  CHECK_THAT(stl.err, Contains("m.stl: expected a mesh of Gmsh (.msh)"));
  CHECK(directory.run({"mesh", "none.msh", "m.g"}).exit_code == 3);
  CHECK_FALSE(directory.has("m.g"));
}

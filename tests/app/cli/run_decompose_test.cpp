// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_decompose.hpp"

#include <filesystem>

#include "support/catch.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::ProgramDirectory;
using contactsim::test::TwoBlocks;

TEST_CASE("a mesh is split, and joined again", "[app][decompose]") {
  const TwoBlocks directory;
  const auto [code, out, err] = directory.run({"split", "two_blocks.g", "3"});
  CHECK(err == "");
  CHECK(code == 0);
  CHECK_THAT(out, Contains("two_blocks.g.3.0: ") && Contains("two_blocks.g.3.2: ") &&
                      Contains("nodes, 24 elements\n"));
  const auto joined = directory.run({"join", "two_blocks.g.3.0", "joined.g"});
  CHECK(joined.exit_code == 0);
  CHECK_THAT(joined.out, Contains("joined.g: ") && Contains("72 elements, 0 times, joined from 3 pieces"));
  const auto again = directory.run({"split", "two_blocks.g", "3"});
  CHECK(again.exit_code == 3);
  CHECK_THAT(again.err, Contains("two_blocks.g.3.0: is there already"));
  CHECK(directory.run({"join", "two_blocks.g"}).exit_code == 3);
}

TEST_CASE("a run on pieces gives the bytes of one on the mesh", "[app][decompose]") {
  const TwoBlocks directory;
  // Names of files, and with them of the deck's lines in the results, stay the same.
  REQUIRE(directory.run({"two_blocks.i", "-q"}).exit_code == 0);
  const std::string whole = directory.read("two_blocks.e");
  REQUIRE(directory.run({"split", "two_blocks.g", "5"}).exit_code == 0);
  std::filesystem::remove(directory.path("two_blocks.g"));
  const auto [code, out, err] = directory.run({"two_blocks.i"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("Mesh two_blocks.g.5.0\n  joined from 5 pieces\n"));
  // The command line, which the results hold, differs by -q.
  REQUIRE(directory.run({"two_blocks.i", "-q"}).exit_code == 0);
  CHECK(directory.read("two_blocks.e") == whole);
}

TEST_CASE("results are no pieces of the mesh that is read", "[app][decompose]") {
  const TwoBlocks directory;
  REQUIRE(directory.run({"split", "two_blocks.g", "2"}).exit_code == 0);
  std::filesystem::remove(directory.path("two_blocks.g"));
  const std::string piece = directory.read("two_blocks.g.2.1");
  const auto [code, out, err] = directory.run({"two_blocks.i", "-o", "two_blocks.g.2.1"});
  CHECK(code == 3);
  CHECK_THAT(err, Contains("would overwrite a piece of the mesh, two_blocks.g.2.1"));
  CHECK(directory.read("two_blocks.g.2.1") == piece);
}

TEST_CASE("several decompositions of a mesh are told apart by name", "[app][decompose]") {
  const TwoBlocks directory;
  REQUIRE(directory.run({"split", "two_blocks.g", "2"}).exit_code == 0);
  REQUIRE(directory.run({"split", "two_blocks.g", "4"}).exit_code == 0);
  std::filesystem::remove(directory.path("two_blocks.g"));
  const auto [code, out, err] = directory.run({"two_blocks.i", "--check"});
  CHECK(code == 3);
  CHECK_THAT(err, Contains("two_blocks.g.2.0 or two_blocks.g.4.0"));
  CHECK(directory.run({"two_blocks.i", "two_blocks.g.4.0", "--check"}).exit_code == 0);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_mesh.hpp"

#include "support/catch.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::ProgramDirectory;

namespace {

constexpr const char* deck_of_contact = "contact surface all contains left right\n";

}  // namespace

TEST_CASE("a mesh of the command line goes before the deck's DATABASE NAME", "[app][mesh]") {
  const contactsim::test::TwoBlocks directory;
  const std::string mesh = directory.read("two_blocks.g");
  directory.write("two_blocks.g", "not this one");
  directory.write("other.g", mesh);
  CHECK(directory.run({"two_blocks.i", "--check"}).exit_code == 3);
  const auto [code, out, err] = directory.run({"two_blocks.i", "other.g", "--check"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("\nMesh other.g\n"));
}

TEST_CASE("a deck that names no mesh takes its own base name and .g", "[app][mesh]") {
  const ProgramDirectory directory;
  directory.copy_decks({"two_blocks.g"});
  directory.write("two_blocks.deck", deck_of_contact);
  const auto [code, out, err] = directory.run({"two_blocks.deck", "--check"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("\nMesh two_blocks.g\n"));
}

TEST_CASE("a missing mesh of the command line is a file error", "[app][mesh]") {
  const ProgramDirectory directory;
  directory.write("plate.i", deck_of_contact);
  const auto [code, out, err] = directory.run({"plate.i", "no.g", "--check"});
  CHECK(code == 3);
  CHECK(err == "error: no.g: no such file\n");
}

TEST_CASE("a missing mesh of the deck is reported with the line that names it", "[app][mesh]") {
  const ProgramDirectory directory;
  directory.copy_decks({"two_blocks.i"});
  const auto [code, out, err] = directory.run({"two_blocks.i", "--check"});
  CHECK(code == 3);
  CHECK(err ==
        "error: two_blocks.g: no such file; it is the DATABASE NAME at two_blocks.i:31:21; a mesh named on "
        "the command line, after the deck, goes before it\n");
}

TEST_CASE("a mesh that a deck does not name and that is not there is reported so", "[app][mesh]") {
  const ProgramDirectory directory;
  directory.write("plate.i", deck_of_contact);
  const auto [code, out, err] = directory.run({"plate.i", "--check"});
  CHECK(code == 3);
  CHECK(err ==
        "error: plate.g: no such file; the deck names no mesh, so its own base name is taken; a mesh named "
        "on the command line, after the deck, goes before it\n");
}

TEST_CASE("a mesh beside a deck elsewhere is pointed at, not taken", "[app][mesh]") {
  const contactsim::test::TwoBlocks directory;
  directory.write("run/x", "");
  directory.write("sub/two_blocks.i", directory.read("two_blocks.i"));
  directory.write("sub/two_blocks.g", directory.read("two_blocks.g"));
  std::filesystem::remove(directory.path("two_blocks.g"));
  const auto [code, out, err] = directory.run({"sub/two_blocks.i", "--check"});
  CHECK(code == 3);
  CHECK_THAT(err, Contains("add 'sub/two_blocks.g' to the command line"));
  CHECK(directory.run({"sub/two_blocks.i", "sub/two_blocks.g", "--check"}).exit_code == 0);
}

TEST_CASE("what is no mesh is called what it is", "[app][mesh]") {
  const ProgramDirectory directory;
  directory.write("plate.i", deck_of_contact);
  directory.write("directory/x", "");
  directory.write("text", "nodes 3\n");
  directory.write("empty", "");
  directory.write("pointer", "version https://git-lfs.github.com/spec/v1\noid sha256:0123\nsize 4\n");
  const auto [name, said] = GENERATE(table<std::string, std::string>({
      {"pointer", "is a git-lfs pointer, not the mesh itself; fetch the mesh with 'git lfs pull'"},
      {"text", "is a text file, not an Exodus mesh"},
      {"plate.i", "is a text file, not an Exodus mesh"},
      {"directory", "is a directory, not an Exodus mesh"},
      {"empty", "empty"},
  }));
  const auto [code, out, err] = directory.run({"plate.i", name, "--check"});
  CHECK(code == 3);
  CHECK_THAT(err, Contains("error: " + name + ": ") && Contains(said));
}

TEST_CASE("a mesh cut short is refused", "[app][mesh]") {
  const contactsim::test::TwoBlocks directory;
  const std::string mesh = directory.read("two_blocks.g");
  directory.write("two_blocks.g", mesh.substr(0, mesh.size() - GENERATE(std::size_t{1}, 100, 4000)));
  const auto [code, out, err] = directory.run({"two_blocks.i", "--check"});
  CHECK(code == 3);
  CHECK_THAT(err, Contains("error: two_blocks.g: "));
}

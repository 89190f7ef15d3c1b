// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/file_clashes.hpp"

#include <filesystem>

#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;

namespace {

std::string clash(const std::vector<RunFile>& read, const std::vector<RunFile>& written) {
  return find_file_clash(read, written);
}

}  // namespace

TEST_CASE("files of different names do not clash", "[app][files]") {
  CHECK(clash({{"plate.i", "the deck"}, {"plate.g", "the mesh"}},
              {{"plate.log", "the log"}, {"plate.json", "the table"}}) == "");
}

TEST_CASE("a written file may not be one that is read, however its path is spelled", "[app][files]") {
  const test::TemporaryDirectory directory;
  test::write_bytes(directory.file("plate.i"), "deck");
  std::filesystem::create_symlink(directory.file("plate.i"), directory.file("link"));
  const std::string deck = directory.file("plate.i");
  CHECK(clash({{deck, "the deck"}}, {{directory.file("./x/../plate.i"), "the log"}}) != "");
  CHECK(clash({{deck, "the deck"}}, {{directory.file("link"), "the log"}}) ==
        "the log would overwrite the deck, " + deck);
}

TEST_CASE("two files that are not there yet clash when they are one", "[app][files]") {
  CHECK(clash({}, {{"no/such/a", "the log"}, {"no/such/../such/a", "the table"}}) ==
        "the table would overwrite the log, no/such/a");
}

TEST_CASE("links to what is not there yet are followed", "[app][files]") {
  const test::TemporaryDirectory directory;
  std::filesystem::create_symlink("later", directory.file("first"));
  std::filesystem::create_symlink("first", directory.file("second"));
  CHECK(clash({}, {{directory.file("later"), "the log"}, {directory.file("second"), "the table"}}) != "");
  std::filesystem::create_symlink("round", directory.file("round"));
  CHECK(clash({}, {{directory.file("later"), "the log"}, {directory.file("round"), "the table"}}) == "");
}

TEST_CASE("no file takes the name under which another is written until it is complete", "[app][files]") {
  CHECK(clash({}, {{"a.e", "the results"}, {"./a.e.part", "the log"}}) ==
        "the log would overwrite the results, a.e");
  CHECK(clash({{"a.e.part", "the mesh"}}, {{"a.e", "the results"}}) ==
        "the results would overwrite the mesh, a.e.part");
  CHECK(clash({{"a.e", "the mesh"}}, {{"a.e.part", "the log"}}) == "");
}

TEST_CASE("a device takes any number of files", "[app][files]") {
  CHECK(clash({}, {{"/dev/null", "the log"}, {"/dev/null", "the table"}}) == "");
}

TEST_CASE("a link to a file that is not there yet is that file", "[app][files]") {
  const test::TemporaryDirectory directory;
  std::filesystem::create_symlink("plate.log", directory.file("link"));
  CHECK(clash({}, {{directory.file("plate.log"), "the log"}, {directory.file("link"), "the table"}}) != "");
  CHECK(clash({}, {{directory.file("other.log"), "the log"}, {directory.file("link"), "the table"}}) == "");
}

TEST_CASE("files differ also where the path of the working folder is too long", "[app][files]") {
  namespace fs = std::filesystem;
  const test::TemporaryDirectory directory;
  const fs::path before = fs::current_path();
  fs::current_path(directory.file(""));
  const std::string name(200, 'd');
  for (int depth = 0; depth < 25; ++depth) {
    fs::create_directory(name);
    fs::current_path(name);
  }
  CHECK(clash({{"plate.i", "the deck"}}, {{"plate.log", "the log"}, {"plate.e", "the results"}}) == "");
  CHECK(clash({{"plate.i", "the deck"}}, {{"./plate.i", "the log"}}) != "");
  fs::current_path(before);
}

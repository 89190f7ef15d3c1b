// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_decompose.hpp"

#include <filesystem>
#include <regex>

#include "support/catch.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::ProgramDirectory;
using contactsim::test::TwoBlocks;

namespace {

/// The bytes of results without the time of day, which their QA records hold.
std::string without_time_of_day(const std::string& bytes) {
  static const std::regex clock(R"([0-9]{2}:[0-9]{2}:[0-9]{2}|[0-9]{4}[/-][0-9]{2}[/-][0-9]{2})");
  return std::regex_replace(bytes, clock, "");
}

}  // namespace

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
  const std::string whole = without_time_of_day(directory.read("two_blocks.e"));
  REQUIRE(directory.run({"split", "two_blocks.g", "5"}).exit_code == 0);
  std::filesystem::remove(directory.path("two_blocks.g"));
  const auto [code, out, err] = directory.run({"two_blocks.i"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("Mesh two_blocks.g.5.0\n  joined from 5 pieces\n"));
  // The command line, which the results hold, differs by -q.
  REQUIRE(directory.run({"two_blocks.i", "-q"}).exit_code == 0);
  const bool is_same = without_time_of_day(directory.read("two_blocks.e")) == whole;
  CHECK(is_same);
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

TEST_CASE("reports and comparisons take pieces", "[app][decompose]") {
  const TwoBlocks directory;
  REQUIRE(directory.run({"two_blocks.i", "-q"}).exit_code == 0);
  REQUIRE(directory.run({"split", "two_blocks.e", "3"}).exit_code == 0);
  REQUIRE(directory.run({"split", "two_blocks.g", "2"}).exit_code == 0);
  for (const char* whole : {"two_blocks.e", "two_blocks.g"}) std::filesystem::remove(directory.path(whole));
  const auto report = directory.run({"report", "two_blocks.e.3.0"});
  CHECK(report.err == "");
  CHECK_THAT(report.out, Contains("two_blocks.html, "));
  const auto diff = directory.run({"diff", "two_blocks.i", "two_blocks.i", "two_blocks.g"});
  CHECK(diff.exit_code == 0);
  CHECK_THAT(diff.out, Contains("no differences"));
}

TEST_CASE("a mesh in pieces beside the deck is told of", "[app][decompose]") {
  const TwoBlocks directory;
  REQUIRE(directory.run({"split", "two_blocks.g", "2"}).exit_code == 0);
  std::filesystem::remove(directory.path("two_blocks.g"));
  directory.write("decks/two_blocks.i", directory.read("two_blocks.i"));
  for (const char* piece : {"two_blocks.g.2.0", "two_blocks.g.2.1"})
    std::filesystem::rename(directory.path(piece), directory.path(std::string("decks/") + piece));
  const auto [code, out, err] = directory.run({"decks/two_blocks.i", "--check"});
  CHECK(code == 3);
  CHECK_THAT(err, Contains("or add 'decks/two_blocks.g' to the command line"));
  CHECK(directory.run({"decks/two_blocks.i", "decks/two_blocks.g", "--check"}).exit_code == 0);
}

TEST_CASE("the fingerprint of a mesh in pieces is that of all of them", "[app][decompose]") {
  const TwoBlocks directory;
  REQUIRE(directory.run({"split", "two_blocks.g", "2"}).exit_code == 0);
  std::filesystem::remove(directory.path("two_blocks.g"));
  const auto digest = [&] {
    REQUIRE(directory.run({"two_blocks.i", "--check", "--summary", "s.json"}).exit_code == 0);
    const std::string text = directory.read("s.json");
    const std::size_t mesh = text.find("\"mesh\""), at = text.find("\"digest\"", mesh);
    REQUIRE(at != std::string::npos);
    return text.substr(at, 30);
  };
  const std::string before = digest();
  // What stands behind the data of a file is not read.
  directory.write("two_blocks.g.2.1", directory.read("two_blocks.g.2.1") + "x");
  CHECK(digest() != before);
}

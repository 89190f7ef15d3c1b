// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/program.hpp"

#include <sstream>

#include "support/catch.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::ProgramDirectory;
using contactsim::test::ProgramOutput;
using contactsim::test::TwoBlocks;

namespace {

constexpr const char* surface_warnings =
    "two_blocks.i:59:9: warning: surface 'left': 4 faces already in surface 'top' [surface-overlap]\n"
    "two_blocks.i:59:9: warning: surface 'right': 4 faces already in surface 'top' [surface-overlap]\n";

}  // namespace

TEST_CASE("a run that does what was asked ends with code 0", "[app][program]") {
  CHECK(TwoBlocks().run({"two_blocks.i", "--check"}).exit_code == 0);
  CHECK(TwoBlocks().run({"two_blocks.i", "--parse"}).exit_code == 0);
}

TEST_CASE("a deck that is not there ends with code 3 and leaves no log", "[app][program]") {
  const ProgramDirectory directory;
  const auto [code, out, err] = directory.run({"plate.i", "--parse"});
  CHECK(code == 3);
  CHECK(out == "");
  CHECK(err == "error: plate.i: there is no such deck\n");
  CHECK(directory.list().empty());
}

TEST_CASE("a directory in place of the deck ends with code 3 and leaves no log", "[app][program]") {
  const ProgramDirectory directory;
  directory.write("plate.i/x", "");
  const auto [code, out, err] = directory.run({"plate.i", "--parse"});
  CHECK(code == 3);
  CHECK(err == "error: plate.i: this is a directory, not a deck\n");
  CHECK(directory.list() == std::vector<std::string>{"plate.i"});
}

TEST_CASE("an empty deck, or one of comments, is a wrong deck", "[app][program]") {
  const ProgramDirectory directory;
  directory.write("plate.i", GENERATE("", "\n\n", "# nothing yet\n"));
  const auto [code, out, err] = directory.run({"plate.i", "--parse"});
  CHECK(code == 2);
  CHECK(err ==
        "error: plate.i: the deck is empty; it should have a BEGIN SIERRA block\n"
        "contactsim: 1 error\n");
}

TEST_CASE("a mesh in place of the deck is called what it is", "[app][program]") {
  const auto [code, out, err] = TwoBlocks().run({"two_blocks.g", "--parse"});
  CHECK(code == 2);
  CHECK_THAT(err, Contains("two_blocks.g is no deck: it is a mesh (NetCDF) file"));
}

TEST_CASE("explain prints the reference of a block or command and writes no files", "[app][program]") {
  const ProgramDirectory directory;
  const auto [code, out, err] = directory.run({"explain", "contact", "node", "set"});
  CHECK(code == 0);
  CHECK(err == "");
  CHECK_THAT(out, Contains("CONTACT NODE SET <name> CONTAINS"));
  CHECK(directory.run({"explain", "CONTACT_NODE set"}).out == out);
  CHECK(directory.list().empty());
}

TEST_CASE("explain without words prints the tree of blocks", "[app][program]") {
  const auto [code, out, err] = ProgramDirectory().run({"explain"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("BEGIN SIERRA") && Contains("BEGIN CONTACT DEFINITION"));
}

TEST_CASE("explain answers an unknown word with the nearest known ones", "[app][program]") {
  const auto [code, out, err] = ProgramDirectory().run({"explain", "frictoin", "coefficient"});
  CHECK(code == 2);
  CHECK(out.empty());
  CHECK_THAT(err, Contains("No block or command is called 'frictoin coefficient'") &&
                      Contains("\n  friction coefficient\n"));
}

namespace {

/// A log without what it alone holds: its head, and times of the clock.
std::string without_clock(const std::string& log) {
  std::string kept;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    const bool is_of_clock = line.starts_with("  date  ") || line.starts_with("  command  ") ||
                             line.starts_with("  host  ") || line.find("s of the clock") != std::string::npos;
    if (!is_of_clock) kept += line + "\n";
  }
  return kept;
}

}  // namespace

TEST_CASE("the log file holds all that was printed, errors and warnings too", "[app][program]") {
  const TwoBlocks directory;
  const auto [code, out, err] = directory.run({"two_blocks.i", "--check"});
  CHECK(without_clock(directory.read("two_blocks.log")) == out + err);
  CHECK(directory.list() == std::vector<std::string>{"two_blocks.g", "two_blocks.i", "two_blocks.log"});
  const auto wrong = directory.run({"two_blocks.i", "no.g", "--check"});
  CHECK(without_clock(directory.read("two_blocks.log")) == wrong.out + wrong.err);
}

TEST_CASE("the log of a deck elsewhere goes to the run directory", "[app][program]") {
  const ProgramDirectory directory;
  directory.write("sub/plate.i", "contact surface a contains b\n");
  CHECK(directory.run({"sub/plate.i", "--parse"}).exit_code == 0);
  CHECK(directory.has("plate.log"));
  CHECK_FALSE(directory.has("sub/plate.log"));
}

TEST_CASE("an option --log names the log file, and then there is no other", "[app][program]") {
  const TwoBlocks directory;
  const auto [code, out, err] = directory.run({"two_blocks.i", "--check", "--log", "my log.txt"});
  CHECK(code == 0);
  CHECK(without_clock(directory.read("my log.txt")) == out + err);
  CHECK_FALSE(directory.has("two_blocks.log"));
}

TEST_CASE("a log that cannot be written ends with code 3", "[app][program]") {
  const auto [code, out, err] = TwoBlocks().run({"two_blocks.i", "--check", "--log", "no/such/l.log"});
  CHECK(code == 3);
  CHECK(out == "");
  CHECK(err == "error: no/such/l.log: the log file cannot be written\n");
}

TEST_CASE("a full disk under the log or under standard output is reported", "[app][program]") {
  const auto log = TwoBlocks().run({"two_blocks.i", "--check", "--log", "/dev/full"});
  CHECK(log.exit_code == 3);
  CHECK_THAT(log.err, Contains("error: /dev/full: the log file cannot be written\n"));
  const auto out = TwoBlocks().run_into_full_device({"two_blocks.i", "--check"});
  CHECK(out.exit_code == 3);
  CHECK_THAT(out.err, Contains("error: standard output: what the run prints cannot be written\n"));
}

TEST_CASE("warnings are repeated at the end and counted", "[app][program]") {
  const auto [code, out, err] = TwoBlocks().run({"two_blocks.i", "--check"});
  CHECK(code == 0);
  CHECK(out.ends_with("\n\n2 warnings\n"));
  CHECK(err == surface_warnings);
}

TEST_CASE("no colours and no carets reach a file", "[app][program]") {
  const ProgramDirectory directory;
  directory.write("plate.i", "begin sierra\n  bogus = 3\nend\n");
  const auto [code, out, err] = directory.run({"plate.i", "--parse"});
  CHECK(code == 2);
  CHECK(err ==
        "plate.i:2:3: error: unknown command 'bogus = 3' in 'sierra'\n"
        "contactsim: 1 error\n");
  CHECK(directory.read("plate.log").find('\033') == std::string::npos);
}

TEST_CASE("on a terminal problems are coloured and underlined, in the log they are not", "[app][program]") {
  const ProgramDirectory directory;
  directory.write("plate.i", "begin sierra\n  bogus = 3\nend\n");
  const auto [code, out, err] = directory.run_on_terminal({"plate.i", "--parse"});
  CHECK(code == 2);
  CHECK_THAT(err, Contains("\033[31merror: \033[0m") && Contains("      bogus = 3\n      ^~~~~~~~~\n"));
  const std::string log = directory.read("plate.log");
  CHECK_THAT(log, Contains("plate.i:2:3: error: unknown command") && !Contains("\033") && !Contains("^~"));
}

TEST_CASE("a file that is read is never overwritten", "[app][program]") {
  const TwoBlocks directory;
  const std::string deck = directory.read("two_blocks.i"), mesh = directory.read("two_blocks.g");
  struct Clash {
    std::vector<std::string> arguments;
    std::string said;
  };
  const auto [arguments, said] = GENERATE(values<Clash>({
      {{"--log", "two_blocks.i"}, "the log would overwrite the deck, two_blocks.i"},
      {{"two_blocks.g", "--log", "./two_blocks.g"}, "the log would overwrite the mesh, two_blocks.g"},
      {{"--log", "two_blocks.g"}, "the log would overwrite the mesh, two_blocks.g"},
      {{"--surfaces-json", "two_blocks.i"}, "the file of --surfaces-json would overwrite the deck"},
      {{"--surfaces", "two_blocks.g"}, "the file of --surfaces would overwrite the mesh, two_blocks.g"},
  }));
  std::vector<std::string> line{"two_blocks.i", "--check"};
  line.insert(line.begin() + 1, arguments.begin(), arguments.end());
  const auto [code, out, err] = directory.run(line);
  CHECK((code == 2 || code == 3));
  CHECK_THAT(err, Contains(said));
  CHECK(directory.read("two_blocks.i") == deck);
  CHECK(directory.read("two_blocks.g") == mesh);
}

TEST_CASE("a deck called like its own log is left alone", "[app][program]") {
  const ProgramDirectory directory;
  directory.write("plate.log", "contact surface a contains b\n");
  const auto [code, out, err] = directory.run({"plate.log", "--parse"});
  CHECK(code == 2);
  CHECK(err == "error: the log would overwrite the deck, plate.log\n");
  CHECK(directory.read("plate.log") == "contact surface a contains b\n");
}

TEST_CASE("nothing is written where a file of the run would be lost", "[app][program]") {
  const TwoBlocks directory;
  const std::string deck = directory.read("two_blocks.i");
  directory.write("more.inc", "# nothing\n");
  const auto run = [&](const std::vector<std::string>& arguments, const std::string& files) {
    std::string changed = "{include(\"more.inc\")}\n" + deck;
    const auto at = changed.find('\n', changed.find("begin presto region"));
    changed.insert(at + 1, files);
    directory.write("a.i", changed);
    std::vector<std::string> line{"a.i", "two_blocks.g"};
    line.insert(line.end(), arguments.begin(), arguments.end());
    return directory.run(line);
  };
  const std::string results = "begin results output\ndatabase name = %\nat step 0 increment = 1\nend\n",
                    states = "begin restart data\ndatabase name = a.rsout\nat step 0 increment = 1\nend\n";
  const auto named = [&](const std::string& name) {
    std::string text = results;
    return text.replace(text.find('%'), 1, name);
  };
  directory.write("old.e", "results of an earlier run");
  const auto said = [&](const ProgramOutput& of) {
    CHECK(of.exit_code == 3);
    return of.err;
  };
  CHECK_THAT(said(run({"--log", "more.inc"}, "")),
             Contains("the log would overwrite a file that the deck includes"));
  CHECK_THAT(said(run({}, named("more.inc"))),
             Contains("more.inc would overwrite a file that the deck includes"));
  CHECK_THAT(said(run({"--surfaces-csv", "old.e"}, named("old.e"))),
             Contains("the output file old.e would overwrite the file of --surfaces-csv"));
  CHECK_THAT(said(run({}, states + named("a.rsout.1"))),
             Contains("would overwrite a restart state of a.rsout"));
  CHECK_THAT(said(run({"-o", "./a.rsout-s0002.3"}, states)),
             Contains("the results file would overwrite a restart state"));
  // Of includes that are elsewhere, those are meant.
  directory.write("apart/more.inc", "# nothing\n");
  CHECK_THAT(said(run({"--includes-from", "apart"}, named("apart/more.inc"))),
             Contains("apart/more.inc would overwrite a file that the deck includes"));
  CHECK(directory.read("more.inc") == "# nothing\n");
  CHECK(directory.read("old.e") == "results of an earlier run");
}

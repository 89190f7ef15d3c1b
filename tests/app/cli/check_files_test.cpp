// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/check_files.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A deck a.i, whose lines of the only region are given; % stands for the folder of all files.
struct CheckedRun : TemporaryDirectory {
  explicit CheckedRun(std::string region, const std::string& second = "") {
    const std::string begin = "begin sierra\nbegin finite element model m\ndatabase name = %/m.g\nend\n";
    std::string text = begin + procedure("p", region) + second + "end\n";
    for (std::size_t at = text.find('%'); at != std::string::npos; at = text.find('%', at))
      text.replace(at, 1, path().string());
    write_bytes(file("a.i"), text);
    options.deck = file("a.i");
    options.log = file("a.log");
    deck = read_run_deck({options.deck, {}, false, std::nullopt}, found);
    REQUIRE(messages(found) == "");
  }
  static std::string procedure(const std::string& name, const std::string& region) {
    return "begin presto procedure " + name +
           "\nbegin time control\nbegin time stepping block t\nstart time = 0\nend\ntermination time = "
           "1\nend\n"
           "begin presto region r_" +
           name + "\nuse finite element model m\n" + region + "end\nend\n";
  }
  static std::string results(const std::string& name) {
    return "begin results output\ndatabase name = " + name + "\nat step 0 increment = 1\nend\n";
  }

  /// With the folder of files taken out.
  std::string clash() const {
    std::string text = find_clash_of_run(options, deck);
    const std::string folder = path().string() + "/";
    for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder))
      text.erase(at, folder.size());
    return text;
  }
  std::string outside() const {
    Diagnostics warnings;
    warn_of_files_outside(options, deck, warnings);
    return messages(warnings);
  }

  Options options;
  RunDeck deck;
  Diagnostics found;
};

const std::string restart_states =
    "begin restart data\ndatabase name = %/a.rsout\nat step 0 increment = 1\nend\n";

}  // namespace

TEST_CASE("files of a run that are all different do not clash", "[app][files]") {
  CheckedRun run(CheckedRun::results("%/a.e") + restart_states);
  CHECK(run.clash() == "");
  run.options.results = run.file("a.e");  // the same, said twice
  CHECK(run.clash() == "");
}

TEST_CASE("files that are read are kept: deck, mesh and includes", "[app][files]") {
  CHECK(CheckedRun(CheckedRun::results("%/m.g")).clash() ==
        "the output file m.g would overwrite the mesh, m.g");
  CHECK(CheckedRun(CheckedRun::results("%/a.i")).clash() ==
        "the output file a.i would overwrite the deck, a.i");
  CheckedRun run(CheckedRun::results("%/x.inc"));
  write_bytes(run.file("x.inc"), "");
  run.deck.sources.push_back({run.file("x.inc"), ""});
  CHECK(run.clash() == "the output file x.inc would overwrite a file that the deck includes, x.inc");
  run.options.log = run.file("m.g");
  CHECK(run.clash() == "the log would overwrite the mesh, m.g");
}

TEST_CASE("an output of the deck does not overwrite one of the command line", "[app][files]") {
  CheckedRun run(CheckedRun::results("%/a.e") + CheckedRun::results("%/b.e"));
  run.options.surfaces_csv = run.file("b.e");
  CHECK(run.clash() == "the output file b.e would overwrite the file of --surfaces-csv, b.e");
  run.options.surfaces_csv = run.file("a.log");
  CHECK(run.clash() == "the file of --surfaces-csv would overwrite the log, a.log");
}

TEST_CASE("states of a restart are kept, whatever their number", "[app][files]") {
  CheckedRun run(restart_states);
  CHECK(run.clash() == "");
  run.options.report = run.file("a.rsout.12");
  CHECK(run.clash() == "the file of --report would overwrite a restart state of a.rsout, a.rsout.12");
  CHECK(CheckedRun(restart_states + CheckedRun::results("%/a.rsout.1")).clash() ==
        "the output file a.rsout.1 would overwrite a restart state of a.rsout, a.rsout.1");
  run.options.report = run.file("a.rsout.html");
  CHECK(run.clash() == "");
}

TEST_CASE("the results file of the command line stands for that of the last procedure alone",
          "[app][files]") {
  CheckedRun run(CheckedRun::results("%/m.g"), CheckedRun::procedure("q", CheckedRun::results("%/m.g")));
  run.options.results = run.file("new.e");
  CHECK(run.clash() == "the output file m.g would overwrite the mesh, m.g");
  CheckedRun last(CheckedRun::results("%/a.e"), CheckedRun::procedure("q", CheckedRun::results("%/m.g")));
  last.options.results = last.file("new.e");
  CHECK(last.clash() == "");
}

TEST_CASE("files that a deck writes outside of the run's folder are warned of at their lines",
          "[app][files]") {
  CHECK(CheckedRun(CheckedRun::results("sub/a.e")).outside() == "");
  CHECK(CheckedRun(CheckedRun::results("sub/../a.e")).outside() == "");
  CHECK(CheckedRun(CheckedRun::results("/dev/null")).outside() == "");
  const CheckedRun above(CheckedRun::results("sub/../../a.e"));
  CHECK(above.outside() ==
        above.file("a.i") +
            ":15:17: warning: 'sub/../../a.e' is outside the folder that the run is started in; -o and other "
            "options of the command line name files anywhere [output-outside]\n");
  CheckedRun absolute(CheckedRun::results("%/a.e"));
  CHECK(absolute.outside().find("is outside the folder") != std::string::npos);
  absolute.options.results = "a.e";  // stands for it
  CHECK(absolute.outside() == "");
}

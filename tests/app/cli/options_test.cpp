// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/options.hpp"

#include "app/cli/command_words.hpp"
#include "support/catch.hpp"
#include "support/program_run.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;
using contactsim::test::ProgramDirectory;
using contactsim::test::read_words;

TEST_CASE("a deck alone asks for the whole run", "[app][options]") {
  const auto [options, exit_code] = read_words({"plate.i"});
  REQUIRE_FALSE(exit_code);
  CHECK(options.deck == "plate.i");
  CHECK(options.stage == Stage::run);
  CHECK_FALSE(options.mesh);
  CHECK_FALSE(options.is_lenient);
  CHECK(options.n_threads == 0);
  CHECK(log_path(options) == "plate.log");
}

TEST_CASE("every option reaches its field", "[app][options]") {
  const auto [options, exit_code] = read_words(
      {"decks/plate.i",  "plate.g", "-o",         "r.e",   "--check",   "--surfaces-json", "s.json",
       "--surfaces-csv", "s.csv",   "--surfaces", "s.exo", "--lenient", "--threads",       "3",
       "--log",          "l.txt",   "-D",         "a=1",   "-Db=x y",   "--define",        "c=2"});
  REQUIRE_FALSE(exit_code);
  CHECK(options.stage == Stage::check);
  CHECK(options.mesh == "plate.g");
  CHECK(options.results == "r.e");
  CHECK(options.surfaces_json == "s.json");
  CHECK(options.surfaces_csv == "s.csv");
  CHECK(options.surfaces_exodus == "s.exo");
  CHECK(options.is_lenient);
  CHECK(options.n_threads == 3);
  CHECK(log_path(options) == "l.txt");
  CHECK(options.definitions == std::vector<std::string>{"a=1", "b=x y", "c=2"});
}

TEST_CASE("a -D does not swallow the deck and the mesh after it", "[app][options]") {
  const auto [options, exit_code] = read_words({"-D", "a=1", "plate.i", "plate.g"});
  REQUIRE_FALSE(exit_code);
  CHECK(options.deck == "plate.i");
  CHECK(options.mesh == "plate.g");
}

TEST_CASE("explain takes its words in any number", "[app][options]") {
  const auto [options, exit_code] = read_words({"explain", "contact", "surface"});
  REQUIRE_FALSE(exit_code);
  CHECK(options.explains);
  CHECK(options.explain_words == std::vector<std::string>{"contact", "surface"});
}

TEST_CASE("the text of --help holds every option and the exit codes", "[app][options]") {
  const auto [code, out, err] = ProgramDirectory().run({"--help"});
  CHECK(code == 0);
  CHECK(err == "");
  for (const char* word :
       {"DECK", "MESH", "--output", "--define", "--log", "--threads", "--lenient", "--parse", "--check",
        "--surfaces-json", "--surfaces-csv", "--surfaces FILE", "explain", "--version", "0 done, 1 a bug"}) {
    CHECK_THAT(out, Contains(word));
  }
}

TEST_CASE("the text of --version is one line", "[app][options]") {
  const ProgramDirectory directory;
  const auto [code, out, err] = directory.run({"--version"});
  CHECK(code == 0);
  CHECK(out.starts_with("contactsim "));
  CHECK(out.find('\n') == out.size() - 1);
  CHECK(err == "");
  CHECK(directory.list().empty());
}

TEST_CASE("a wrong command line ends with code 2, says why on standard error and writes nothing",
          "[app][options]") {
  struct Mistake {
    std::vector<std::string> arguments;
    std::string said;
  };
  const auto [arguments, said] = GENERATE(values<Mistake>({
      {{}, "DECK is required"},
      {{"a.i", "--bogus"}, "--bogus"},
      {{"a.i", "b.g", "c.g"}, "c.g"},
      {{"a.i", "--threads", "0"}, "--threads: Value 0 not in range"},
      {{"a.i", "--threads", "many"}, "--threads"},
      {{"a.i", "--log"}, "--log"},
      {{"a.i", "--parse", "--check"}, "excludes"},
      {{"a.i", "--parse", "--surfaces-csv", "s.csv"}, "--parse excludes --surfaces-csv"},
  }));
  const ProgramDirectory directory;
  const auto [code, out, err] = directory.run(arguments);
  CHECK(code == 2);
  CHECK(out == "");
  CHECK_THAT(err, Contains(said));
  CHECK(directory.list().empty());
}

TEST_CASE("a run reads the deck and the mesh and writes what is asked for, the log first", "[app][files]") {
  Options options;
  options.deck = "decks/plate.i";
  options.mesh = "m.g";
  options.surfaces_csv = "s.csv";
  const auto read = files_read(options), written = files_written(options);
  REQUIRE(read.size() == 2);
  CHECK(read[0].path == "decks/plate.i");
  CHECK(read[1].path == "m.g");
  REQUIRE(written.size() == 2);
  CHECK(written[0].path == "plate.log");
  CHECK(written[1].path == "s.csv");
}

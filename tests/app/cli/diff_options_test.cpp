// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/diff_options.hpp"

#include "app/cli/command_words.hpp"
#include "support/catch.hpp"
#include "support/program_run.hpp"

using namespace contactsim;
using contactsim::test::read_words;

TEST_CASE("a diff takes two files, and its usual tolerance", "[app][options]") {
  const auto [options, exit_code] = read_words({"diff", "a.json", "b.json"});
  REQUIRE_FALSE(exit_code);
  CHECK(options.diff.is_asked);
  CHECK_FALSE(options.sweep.is_asked);
  CHECK(options.diff.first == "a.json");
  CHECK(options.diff.second == "b.json");
  CHECK_FALSE(options.diff.mesh);
  CHECK(options.diff.tolerance.rtol == 1e-6);
  CHECK(options.diff.tolerance.atol == 0.0);
  CHECK_FALSE(options.diff.lists_faces);
  CHECK_FALSE(options.diff.writes_json);
  CHECK_FALSE(options.diff.is_lenient);
}

TEST_CASE("every option of a diff reaches its field, definitions swallow nothing", "[app][options]") {
  const auto [options, exit_code] =
      read_words({"diff", "-D", "a=1", "a.i", "--define-first", "b=2", "b.i", "--define-second", "c=3", "m.g",
                  "-D", "d=4", "--rtol", "0", "--atol", "0.5", "--faces", "--json", "--lenient"});
  REQUIRE_FALSE(exit_code);
  CHECK(options.diff.first == "a.i");
  CHECK(options.diff.second == "b.i");
  CHECK(options.diff.mesh == "m.g");
  CHECK(options.diff.definitions == std::vector<std::string>{"a=1", "d=4"});
  CHECK(options.diff.first_definitions == std::vector<std::string>{"b=2"});
  CHECK(options.diff.second_definitions == std::vector<std::string>{"c=3"});
  CHECK(options.diff.tolerance.rtol == 0.0);
  CHECK(options.diff.tolerance.atol == 0.5);
  CHECK(options.diff.lists_faces);
  CHECK(options.diff.writes_json);
  CHECK(options.diff.is_lenient);
  CHECK_FALSE(options.is_lenient);  // of a run
}

TEST_CASE("a diff without two files, or of a negative tolerance, is a wrong command line", "[app][options]") {
  CHECK(read_words({"diff"}).exit_code == ExitCode::deck);
  CHECK(read_words({"diff", "a"}).exit_code == ExitCode::deck);
  CHECK(read_words({"diff", "a", "b", "c", "d"}).exit_code == ExitCode::deck);
  CHECK(read_words({"diff", "a", "b", "--rtol", "-1"}).exit_code == ExitCode::deck);
  CHECK(read_words({"diff", "a", "b", "--atol", "x"}).exit_code == ExitCode::deck);
}

TEST_CASE("a number that is out of range is reported with what may stand there", "[app][options]") {
  const contactsim::test::ProgramDirectory directory;
  const auto said = [&](const std::string& value) {
    const auto [code, out, err] = directory.run({"diff", "a", "b", "--rtol", value});
    CHECK(code == 2);
    return err.substr(0, err.find('\n'));
  };
  for (const char* value : {"-1", "1e999"})
    CHECK(said(value) == "--rtol: expected a number >= 0, found '" + std::string(value) + "'");
  CHECK(directory.run({"sweep", "a.i", "--max-runs", "0"})
            .err.starts_with("--max-runs: expected a number > 0, found '0'\n"));
}

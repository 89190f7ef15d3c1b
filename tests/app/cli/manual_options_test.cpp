// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/manual_options.hpp"

#include <algorithm>

#include "app/cli/command_words.hpp"
#include "app/cli/run_manual.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using contactsim::test::read_words;

namespace {

const OptionText& option_called(const std::vector<OptionText>& options, const std::string& name) {
  const auto found = std::ranges::find_if(options, [&](const OptionText& option) {
    return std::ranges::find(option.names, name) != option.names.end();
  });
  REQUIRE(found != options.end());
  return *found;
}

}  // namespace

TEST_CASE("a manual has a kind, in any case, and perhaps a folder", "[app][options]") {
  const auto [options, exit_code] = read_words({"manual", "HTML", "out"});
  REQUIRE_FALSE(exit_code);
  CHECK(options.manual.is_asked);
  CHECK(options.manual.kind == "HTML");
  CHECK(options.manual.folder == "out");
  CHECK(read_words({"manual"}).exit_code == ExitCode::deck);
  CHECK(read_words({"manual", "tcsh"}).exit_code == ExitCode::deck);
}

TEST_CASE("the command line is described as its reader knows it", "[app][manual]") {
  const CommandLineText commands = read_words({"manual", "man"}).options.manual.command_line;
  std::vector<std::string> names;
  for (const CommandText& command : commands) names.push_back(command.name);
  CHECK(names == std::vector<std::string>{"", "explain", "diff", "sweep", "manual", "mesh", "split", "join",
                                          "report"});

  const CommandText& run = commands[0];
  REQUIRE(run.words.size() == 2);
  CHECK(run.words[0].value == "DECK");
  CHECK(run.words[0].names.empty());
  CHECK(option_called(run.options, "--output").names == std::vector<std::string>{"-o", "--output"});
  CHECK(option_called(run.options, "--output").value == "FILE");
  CHECK(option_called(run.options, "--check").value == "");
  CHECK(option_called(run.options, "--threads").value == "N");  // without the range behind it
  CHECK(run.footer.find("Exit codes") != std::string::npos);

  const CommandText& diff = commands[2];
  REQUIRE(diff.words.size() == 3);
  CHECK(diff.words[0].value == "A");  // what has no word for its value is called as it stands
  CHECK(diff.words[0].is_required);
  CHECK_FALSE(diff.words[2].is_required);
  const CommandText& manual = commands[4];
  CHECK(manual.words.at(0).choices == manual_kinds());
  CHECK(manual.words.at(1).choices.empty());
}

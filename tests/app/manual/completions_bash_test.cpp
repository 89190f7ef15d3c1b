// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/completions.hpp"
#include "app/manual/sample_commands.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

TEST_CASE("bash completes values by their kind, options and words", "[app][manual]") {
  const std::string text = make_bash_completion(sample_commands()).text;
  CHECK_THAT(text, Contains("-o|--output) _contactsim_files ''"));
  CHECK_THAT(text, Contains("--into) compgen -d -- \"$word\""));
  CHECK_THAT(text, Contains("compgen -W '-o --output --quiet' -- \"$word\""));
  CHECK_THAT(text, Contains("compgen -W 'up down' -- \"$word\""));
  CHECK_THAT(text, Contains("_contactsim_files .i .inp"));
}

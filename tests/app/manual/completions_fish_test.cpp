// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/completions.hpp"
#include "app/manual/sample_commands.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

TEST_CASE("fish completes options and words, quoted as it wants them", "[app][manual]") {
  const std::string text = make_fish_completion(sample_commands()).text;
  CHECK_THAT(text, Contains("-s o -l output -F -d 'Results [of a run]: here'"));
  CHECK_THAT(text, Contains("__fish_seen_subcommand_from sort' -x -a 'up down'"));
}

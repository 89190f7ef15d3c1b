// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/completions.hpp"
#include "app/manual/sample_commands.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

TEST_CASE("zsh completes options and words, quoted as it wants them", "[app][manual]") {
  const std::string text = make_zsh_completion(sample_commands()).text;
  CHECK_THAT(text, Contains("'*--output=[Results \\[of a run\\]\\: here]:FILE:_files'"));
  CHECK_THAT(text, Contains("'*--quiet[Prints less]'") && Contains("':KIND:(up down)'"));
}

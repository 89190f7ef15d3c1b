// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/decompose_options.hpp"

#include "app/cli/command_words.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using contactsim::test::read_words;

TEST_CASE("a file is split into a number of pieces", "[app][options]") {
  const auto [options, exit_code] = read_words({"split", "a.g", "16"});
  REQUIRE_FALSE(exit_code);
  CHECK(options.split.is_asked);
  CHECK(options.split.file == "a.g");
  CHECK(options.split.n_pieces == 16);
  for (const char* wrong : {"0", "-1", "x", "2.5"})
    CHECK(read_words({"split", "a.g", wrong}).exit_code == ExitCode::deck);
  CHECK(read_words({"split", "a.g"}).exit_code == ExitCode::deck);
}

TEST_CASE("pieces are joined into a file that may be named", "[app][options]") {
  const auto [options, exit_code] = read_words({"join", "a.g.4.0"});
  REQUIRE_FALSE(exit_code);
  CHECK(options.join.is_asked);
  CHECK(options.join.pieces == "a.g.4.0");
  CHECK_FALSE(options.join.to);
  CHECK(read_words({"join", "a.g", "b.g"}).options.join.to == "b.g");
  CHECK(read_words({"join"}).exit_code == ExitCode::deck);
}

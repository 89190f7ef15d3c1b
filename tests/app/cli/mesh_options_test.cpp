// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/mesh_options.hpp"

#include "app/cli/command_words.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using contactsim::test::read_words;

TEST_CASE("a mesh is made from one file into another", "[app][options]") {
  const auto [options, exit_code] = read_words({"mesh", "a.msh", "a.g"});
  REQUIRE_FALSE(exit_code);
  CHECK(options.convert.is_asked);
  CHECK(options.convert.from == "a.msh");
  CHECK(options.convert.to == "a.g");
  CHECK(read_words({"mesh", "a.msh"}).exit_code == ExitCode::deck);
  CHECK(read_words({"mesh", "a.msh", "a.g", "b.g"}).exit_code == ExitCode::deck);
  CHECK_FALSE(read_words({"a.i"}).options.convert.is_asked);
}

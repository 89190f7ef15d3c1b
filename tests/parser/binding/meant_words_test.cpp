// SPDX-License-Identifier: BSD-3-Clause
// What is said of lines that mean something and are called otherwise here.
#include "support/catch.hpp"
#include "support/parsed_deck.hpp"

using namespace contactsim;
using Catch::Contains;

namespace {

/// The problems of a deck that has these lines in its region.
std::string problems(const std::string& region_lines) {
  const ParsedDeck deck = parsed("begin sierra\nbegin presto procedure p\nbegin presto region r\n" +
                                 region_lines + "end\nend\nend\n");
  return deck.messages;
}

}  // namespace

TEST_CASE("friction in an interaction is reported to be a model", "[parser][hints]") {
  for (const char* line : {"friction = 0.3", "friction coefficient = 0.3"}) {
    const std::string text =
        problems("begin contact definition\nskin all blocks = on\nbegin interaction defaults\n" +
                 std::string(line) + "\nend\nend\n");
    CHECK_THAT(text, Contains("unknown command '" + std::string(line)) &&
                         Contains("BEGIN CONSTANT FRICTION MODEL <name>"));
  }
}

TEST_CASE("words of conditions are reported what says them here", "[parser][hints]") {
  CHECK_THAT(problems("begin initial velocity\nblock = b\ncomponent = z\nvelocity = -5\nend\n"),
             Contains("unknown command 'velocity = -5'") && Contains("MAGNITUDE says it"));
  CHECK_THAT(problems("begin prescribed displacement\nblock = b\ncomponent = x\nvalue = 1\nend\n"),
             Contains("SCALE FACTOR"));
  CHECK_THAT(
      problems("begin results output\ndatabase name = a.e\nat step 0 increment = 1\ndisplacement\nend\n"),
      Contains("NODAL <variable> or ELEMENT <variable>"));
}

TEST_CASE("a line of an inner block is reported where it belongs", "[parser][hints]") {
  CHECK_THAT(problems("begin contact definition\ngeneral contact = on\nend\n"),
             Contains("it belongs into BEGIN INTERACTION DEFAULTS"));
}

TEST_CASE("a block is reported where it belongs, and its whole name", "[parser][hints]") {
  CHECK_THAT(problems("begin interaction defaults\ngeneral contact = on\nend\n"),
             Contains("unknown block 'interaction defaults' in 'presto region r'; it belongs into BEGIN "
                      "CONTACT DEFINITION"));
  CHECK_THAT(
      parsed("begin sierra\nbegin presto procedure p\nbegin region r\nend\nend\nend\n").messages,
      Contains("unknown block 'region r' in 'presto procedure p'; did you mean 'begin presto region'?"));
}

TEST_CASE("a direction is a name", "[parser][hints]") {
  CHECK_THAT(
      problems("begin gravity\ninclude all blocks\ngravitational constant = 9.81\ndirection = 0 0 -1\nend\n"),
      Contains("expected the name of a direction after 'direction', found '0'") &&
          Contains("DEFINE DIRECTION <name> WITH VECTOR"));
}

TEST_CASE("SKIN ALL BLOCKS without ON is one error", "[parser][hints]") {
  const std::string text = problems(
      "begin contact definition\nskin all blocks\nbegin interaction\nsurfaces = bolt hub\nend\nend\n");
  CHECK_THAT(text, Contains("SKIN ALL BLOCKS = ON") && !Contains("unknown contact surface"));
}

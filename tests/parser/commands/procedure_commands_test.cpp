// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/procedure_commands.hpp"

#include "support/catch.hpp"
#include "support/parsed_deck.hpp"

using namespace contactsim;

namespace {

/// A procedure of a kind with one region of a kind, and time parameters of a kind. Lines 2 to 11 of the deck.
std::string procedure(const std::string& kind, const std::string& region, const std::string& parameters) {
  return "begin " + kind +
         " procedure p\n"
         "begin time control\n"
         "begin time stepping block t\n"
         "start time = 0\n"
         "begin parameters for " +
         parameters +
         " region r\nend\n"
         "end\n"
         "termination time = 1\n"
         "end\n"
         "begin " +
         region + " region r\nuse finite element model m\nend\nend\nbegin finite element model m\nend\n";
}

/// "adagio region 'r' at a.i:12:21", or "explicit".
std::string cause(const std::string& kind, const std::string& region, const std::string& parameters) {
  const ParsedDeck deck = parsed_sierra(procedure(kind, region, parameters));
  CHECK(deck.messages == "");
  const auto& by = deck.simulation.procedures.at(0).implicit_by;
  return by ? by->block + " at " + to_string(by->location) : "explicit";
}

}  // namespace

TEST_CASE("a procedure without anything implicit is explicit", "[parser][procedure]") {
  CHECK(cause("presto", "presto", "presto") == "explicit");
  CHECK(cause("solid mechanics", "solid mechanics", "presto") == "explicit");
  CHECK(cause("", "presto", "presto") == "explicit");
}

TEST_CASE("a procedure knows what makes it implicit", "[parser][procedure]") {
  CHECK(cause("adagio", "adagio", "adagio") == "adagio procedure 'p' at a.i:2:24");
  CHECK(cause("", "adagio", "adagio") == "adagio region 'r' at a.i:11:21");
  CHECK(cause("solid mechanics", "solid mechanics", "adagio") ==
        "parameters for adagio region 'r' at a.i:6:36");
}

TEST_CASE("two procedures may be joined by a transfer", "[parser][procedure]") {
  const ParsedDeck deck = parsed_sierra(
      "begin adagio procedure load\nbegin adagio region a\nuse finite element model m\nend\nend\n"
      "begin presto procedure hit\n"
      "begin procedural transfer t\ninclude all blocks\nend\n"
      "begin procedural transfer u\nblock = a b\nremove block = b\nend\n"
      "begin presto region b\nuse finite element model m\nend\nend\n"
      "begin finite element model m\nend\n");
  CHECK(deck.messages == "");
  REQUIRE(deck.simulation.procedures.size() == 2);
  const auto& transfers = deck.simulation.procedures[1].transfers;
  REQUIRE(transfers.size() == 2);
  CHECK(transfers[0].set.includes_all_blocks);
  CHECK(transfers[1].set.blocks.size() == 2);
  CHECK(transfers[1].set.removed_blocks.size() == 1);
  CHECK_FALSE(deck.simulation.procedures[1].implicit_by);
}

TEST_CASE("a transfer names blocks", "[parser][procedure]") {
  const auto messages = [](const std::string& line) {
    return parsed_sierra("begin presto procedure hit\nbegin procedural transfer t\n" + line +
                         "end\nbegin presto region b\nuse finite element model m\nend\nend\n"
                         "begin finite element model m\nend\n")
        .messages;
  };
  CHECK(messages("") ==
        "a.i:3:27: error: the procedural transfer 't' takes over the state of no block; give it INCLUDE ALL "
        "BLOCKS or BLOCK\n");
  CHECK_THAT(messages("include all blok\n"), Catch::Matchers::Contains("did you mean 'include all blocks'?"));
}

TEST_CASE("a procedure has one time control", "[parser][procedure]") {
  const std::string control =
      "begin time control\nbegin time stepping block t\nstart time = 0\nend\ntermination time = 1\nend\n";
  CHECK(parsed_sierra("begin presto procedure p\n" + control + control + "end\n").messages ==
        "a.i:9:1: error: a second TIME CONTROL in one procedure; the first stands at a.i:3:1\n");
}

TEST_CASE("solution control is refused with what to write instead", "[parser][procedure]") {
  CHECK(parsed_sierra("begin procedure p\nbegin solution control description\nuse system main\nbegin system "
                      "main\nend\nend\nend\n")
            .messages ==
        "a.i:3:7: error: block 'solution control description' is not supported and would change the answer; "
        "give "
        "the times of the region in a TIME CONTROL block instead\n");
}

TEST_CASE("a region that names no model takes the only one", "[parser][procedure]") {
  const std::string region = "begin presto procedure p\nbegin presto region r\nend\nend\n";
  const std::string model = "begin finite element model m\nend\n",
                    other = "begin finite element model n\nend\n";
  const ParsedDeck one = parsed_sierra(region + model);
  CHECK(one.messages ==
        "a.i:3:21: warning: the region 'r' has no USE FINITE ELEMENT MODEL; 'm' is taken [deck-model]\n");
  CHECK(find_finite_element_model(one.simulation, one.simulation.procedures.at(0).regions.at(0)) ==
        &one.simulation.finite_element_models.at(0));
  CHECK(parsed_sierra(region).messages ==
        "a.i:3:21: warning: the region 'r' has no USE FINITE ELEMENT MODEL; the mesh is that of the command "
        "line, or <deck base>.g [deck-model]\n");
  CHECK(parsed_sierra(region + model + other).messages ==
        "a.i:3:21: error: the region 'r' has no USE FINITE ELEMENT MODEL; name one of the models\n");
}

// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/sierra_commands.hpp"

#include "support/catch.hpp"
#include "support/parsed_deck.hpp"

using namespace contactsim;

TEST_CASE("the SIERRA block may have several words as its name", "[parser][sierra]") {
  CHECK(parsed("BEGIN SIERRA Puck Game\nEND SIERRA Puck Game\n").simulation.name.text == "Puck Game");
  CHECK(parsed("begin sierra\nend\n").simulation.name.text == "");
}

TEST_CASE("a title is the rest of its line", "[parser][sierra]") {
  const ParsedDeck deck = parsed_sierra("title is this a deck, or - begin not\n");
  CHECK(deck.messages == "");
  CHECK(deck.simulation.title == "is this a deck, or - begin not");
}

TEST_CASE("restart lines are bound", "[parser][sierra]") {
  CHECK(parsed_sierra("restart = automatic\n").simulation.restart.is_automatic);
  CHECK(parsed_sierra("restart is auto\n").simulation.restart.is_automatic);
  CHECK(parsed_sierra("restart time = 0.5\n").simulation.restart.time == 0.5);
  CHECK_FALSE(parsed_sierra("").simulation.restart.time);
}

TEST_CASE("an output scheduler is bound", "[parser][sierra]") {
  const ParsedDeck deck = parsed_sierra("begin output scheduler s\n  at time 0 increment = 1e-3\nend\n");
  CHECK(deck.messages == "");
  const OutputScheduler& scheduler = deck.simulation.output_schedulers.at(0);
  CHECK(scheduler.name.text == "s");
  CHECK(scheduler.schedule.time_phases.at(0).increment == 1e-3);
}

TEST_CASE("an END may be partial, and a wrong one is reported", "[parser][sierra]") {
  CHECK(parsed_sierra("begin function f\nend function\nbegin rigid body b\nend rigid body B\n").messages ==
        "");
  CHECK(
      parsed_sierra("begin rigid body b\nend rigid body c\n").messages ==
      "a.i:3:5: warning: 'end rigid body c' has another name than 'begin rigid body b'; the block begins at "
      "a.i:2:1 [deck-end-name]\n");
}

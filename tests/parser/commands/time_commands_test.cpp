// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/time_commands.hpp"

#include "support/catch.hpp"
#include "support/parsed_deck.hpp"

using namespace contactsim;

namespace {

/// A procedure with one region r and a time control whose lines begin at line 4.
ParsedDeck with_time_control(const std::string& lines) {
  return parsed_sierra("begin presto procedure p\nbegin time control\n" + lines +
                       "end\nbegin presto region r\nuse finite element model m\nend\nend\n"
                       "begin finite element model m\nend\n");
}

}  // namespace

TEST_CASE("a time control is bound", "[parser][time]") {
  const ParsedDeck deck = with_time_control(
      "termination time = 2.0e-3\n"
      "begin time stepping block t1\n"
      "  start time = 0\n"
      "  begin parameters for presto region R\n"
      "    initial time step = 1e-8\n"
      "    time step scale factor = 0.5\n"
      "    time step increase factor = 2\n"
      "    step interval = 10\n"
      "    user time step = 1e-7\n"
      "  end\n"
      "end\n"
      "begin time stepping block t2\n"
      "  start time = 1e-3\n"
      "  begin parameters for presto region r\n"
      "  end\n"
      "end\n");
  CHECK(deck.messages == "");
  const TimeControl& control = *deck.simulation.procedures.at(0).time_control;
  CHECK(control.termination_time == 2e-3);
  REQUIRE(control.time_stepping_blocks.size() == 2);
  CHECK(control.time_stepping_blocks[1].start_time == 1e-3);
  const ExplicitTimeParameters& first = control.time_stepping_blocks[0].explicit_parameters.at(0);
  CHECK(first.initial_time_step == 1e-8);
  CHECK(first.time_step_scale_factor == 0.5);
  CHECK(first.time_step_increase_factor == 2.0);
  CHECK(first.step_interval == 10);
  CHECK(first.user_time_step == 1e-7);
  const ExplicitTimeParameters& second = control.time_stepping_blocks[1].explicit_parameters.at(0);
  CHECK_FALSE(second.initial_time_step);
  CHECK(second.time_step_scale_factor == 0.9);
  CHECK(second.time_step_increase_factor == 1.1);
  CHECK(second.step_interval == 100);
}

TEST_CASE("what a time control lacks is reported", "[parser][time]") {
  CHECK(with_time_control("").messages ==
        "a.i:3:1: error: the time control has no TIME STEPPING BLOCK; add BEGIN TIME STEPPING BLOCK <name>\n"
        "a.i:3:1: error: the time control has no TERMINATION TIME; add TERMINATION TIME = <real>\n");
  CHECK(with_time_control("begin time stepping block t\nend\ntermination time = 1\n").messages ==
        "a.i:4:27: error: the time stepping block 't' has no START TIME; add START TIME = <real>\n");
}

TEST_CASE("time stepping blocks follow each other", "[parser][time]") {
  CHECK(
      with_time_control("begin time stepping block t1\nstart time = 1\nend\n"
                        "begin time stepping block t2\nstart time = 1\nend\n"
                        "termination time = 1\n")
          .messages ==
      "a.i:4:27: error: the time stepping block 't1' starts at 1, not before the termination time 1\n"
      "a.i:7:27: error: the time stepping block 't2' starts at 1, not after 't1', which starts at 1; blocks "
      "follow each other in time\n"
      "a.i:7:27: warning: the time stepping block 't2' starts at 1, not before the termination time 1: it is "
      "never run [time-block-unused]\n");
}

TEST_CASE("a step that the deck gives ends within its time stepping block", "[parser][time]") {
  const auto with_step = [](const std::string& step) {
    return with_time_control(
               "begin time stepping block t1\nstart time = 0\nbegin parameters for presto region r\nuser "
               "time step "
               "= " +
               step +
               "\nend\nend\nbegin time stepping block t2\nstart time = 0.5\nend\ntermination time = 1\n")
        .messages;
  };
  CHECK(with_step("0.5") == "");
  CHECK(with_step("0.6") ==
        "a.i:4:27: error: the time stepping block 't1' lasts 0.5, less than its USER TIME STEP of 0.6\n");
}

TEST_CASE("time stepping blocks have names of their own", "[parser][time]") {
  CHECK(with_time_control("begin time stepping block t\nstart time = 0\nend\n"
                          "begin time stepping block T\nstart time = 1\nend\n"
                          "termination time = 2\n")
            .messages ==
        "a.i:7:27: error: the time stepping block 'T' is defined a second time; the first stands at "
        "a.i:4:27\n");
}

TEST_CASE("time parameters are for a region of the procedure", "[parser][time]") {
  CHECK(with_time_control("begin time stepping block t\nstart time = 0\nbegin parameters for presto region "
                          "q\nend\nend\ntermination time = 2\n")
            .messages == "a.i:6:36: error: unknown region 'q' of this procedure; did you mean 'r'?\n");
}

TEST_CASE("a termination time that is given twice is warned about", "[parser][time]") {
  CHECK(with_time_control("begin time stepping block t\nstart time = 0\nend\ntermination time = 2\n"
                          "termination time = 3\n")
            .messages ==
        "a.i:8:1: warning: 'termination time' is given twice in one block, this one counts; the other stands "
        "at "
        "a.i:7:1 [deck-repeated]\n");
}

TEST_CASE("lines without effect on the time step are ignored", "[parser][time]") {
  CHECK(
      with_time_control("begin time stepping block t\nstart time = 0\nbegin parameters for presto region r\n"
                        "time step selector = auto\nend\nend\ntermination time = 2\n")
          .messages ==
      "a.i:7:1: warning: 'time step selector' has no effect here; the smallest step of all elements is taken "
      "[deck-ignored]\n");
}

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/manual/command_line.hpp"

namespace contactsim::test {

/// A program of one subcommand, with what is hard to quote.
inline CommandLineText sample_commands() {
  CommandText run{
      "", "Runs 'decks'", {{{}, "DECK", "Input deck"}, {{}, "MESH", "Its mesh"}}, {}, "Examples:   a-b"};
  run.options = {{{"-o", "--output"}, "FILE", "Results [of a run]: here"}, {{"--quiet"}, "", "Prints less"}};
  CommandText sort{"sort", "Sorts", {{{}, "KIND", "How", true, {"up", "down"}}}, {}, ""};
  sort.options = {{{"--into"}, "FOLDER", ".begins with a stop"}};
  return {run, sort};
}

}  // namespace contactsim::test

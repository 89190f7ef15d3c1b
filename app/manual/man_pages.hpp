// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/manual/command_line.hpp"
#include "app/manual/manual_file.hpp"

namespace contactsim {

/// contactsim(1), the program and its subcommands, in the macros of man(7).
ManualFile make_program_page(const CommandLineText& commands);

/// contactsim-deck(5): every block of a deck and every line that may stand in it.
ManualFile make_deck_page();

}  // namespace contactsim

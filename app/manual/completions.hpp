// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/manual/command_line.hpp"
#include "app/manual/manual_file.hpp"

namespace contactsim {

/// What the shells need to complete subcommands, options, decks, meshes and the words of `explain`.
ManualFile make_bash_completion(const CommandLineText& commands);
ManualFile make_zsh_completion(const CommandLineText& commands);
ManualFile make_fish_completion(const CommandLineText& commands);

}  // namespace contactsim

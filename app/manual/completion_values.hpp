// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "app/manual/command_line.hpp"

namespace contactsim {

/// What may stand for a value, by the word that the help has for it.
enum class Completes { nothing, deck, mesh, file, folder, words, phrases };
Completes completion_of(const OptionText& option);

/// The words of all phrases of the deck language, for `explain`.
std::string phrase_words();

/// All names of options.
std::string names_of(const std::vector<OptionText>& options);

/// The names of all subcommands.
std::string subcommands_of(const CommandLineText& commands);

}  // namespace contactsim

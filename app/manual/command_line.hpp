// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace contactsim {

/// An option of the command line as its reader knows it, or a word that stands by its position.
struct OptionText {
  std::vector<std::string> names;  ///< "-o", "--output"; none of a word by position
  std::string value;               ///< what it takes, "FILE", "N"; "" for nothing
  std::string help;
  bool is_required = false;
  std::vector<std::string> choices = {};  ///< the words that it may be; none: any
};

/// The program without a subcommand, or one of them.
struct CommandText {
  std::string name;  ///< "diff", "" of the program itself
  std::string help;
  std::vector<OptionText> words;    ///< by position
  std::vector<OptionText> options;  ///< by name
  std::string footer;               ///< what --help says at its end
};

/// What the command line understands: the program itself first, then its subcommands.
using CommandLineText = std::vector<CommandText>;

}  // namespace contactsim

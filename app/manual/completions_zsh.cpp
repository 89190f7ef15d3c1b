// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/manual/completion_values.hpp"
#include "app/manual/completions.hpp"

namespace contactsim {

namespace {

/// Text inside a description of _arguments, in single quotes.
std::string zsh_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') escaped += '\\';
    escaped += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return escaped;
}

std::string zsh_action(const OptionText& option) {
  switch (completion_of(option)) {
    case Completes::deck:
      return "_files -g \"*.(i|inp)\"";
    case Completes::mesh:
      return "_files -g \"*.(g|e|exo|gen)\"";
    case Completes::file:
      return "_files";
    case Completes::folder:
      return "_files -/";
    case Completes::words:
      return fmt::format("({})", fmt::join(option.choices, " "));
    case Completes::phrases:
      return fmt::format("({})", phrase_words());
    case Completes::nothing:
      break;
  }
  return " ";
}

std::string zsh_arguments(const CommandText& command) {
  std::string text = "_arguments -s";
  for (const OptionText& option : command.options) {
    for (const std::string& name : option.names) {
      const char* glue = option.value.empty() ? "" : name.starts_with("--") ? "=" : "+";
      text += fmt::format(" \\\n        '*{}{}[{}]", name, glue, zsh_text(option.help));
      text += option.value.empty() ? "'" : fmt::format(":{}:{}'", zsh_text(option.value), zsh_action(option));
    }
  }
  for (const OptionText& word : command.words) {
    const char* place = completion_of(word) == Completes::phrases ? "*" : "";
    text += fmt::format(" \\\n        '{}:{}:{}'", place, zsh_text(word.value), zsh_action(word));
  }
  return text + "\n";
}

}  // namespace

ManualFile make_zsh_completion(const CommandLineText& commands) {
  std::string text =
      "#compdef contactsim\n# written by `contactsim manual zsh`\n_contactsim() {\n  case $words[2] in\n";
  for (const CommandText& command : commands) {
    if (command.name.empty()) continue;
    text += fmt::format("    {})\n      shift words; (( CURRENT-- ))\n      {}      ;;\n", command.name,
                        zsh_arguments(command));
  }
  text += fmt::format(
      "    *)\n      (( CURRENT == 2 )) && compadd {}\n      {}      ;;\n  esac\n}}\n_contactsim \"$@\"\n",
      subcommands_of(commands), zsh_arguments(commands.front()));
  return {"zsh/vendor-completions/_contactsim", text};
}

}  // namespace contactsim

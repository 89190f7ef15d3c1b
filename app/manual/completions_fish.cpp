// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/manual/completion_values.hpp"
#include "app/manual/completions.hpp"

namespace contactsim {

namespace {

std::string fish_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\'' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string fish_value(const OptionText& option) {
  switch (completion_of(option)) {
    case Completes::deck:
    case Completes::mesh:
    case Completes::file:
      return " -F";
    case Completes::folder:
      return " -x -a '(__fish_complete_directories)'";
    case Completes::words:
      return fmt::format(" -x -a '{}'", fmt::join(option.choices, " "));
    case Completes::phrases:
      return fmt::format(" -x -a '{}'", phrase_words());
    case Completes::nothing:
      break;
  }
  return " -x";
}

std::string fish_command(const CommandText& command, const std::string& subcommands) {
  const std::string when = command.name.empty()
                               ? fmt::format("not __fish_seen_subcommand_from {}", subcommands)
                               : "__fish_seen_subcommand_from " + command.name;
  std::string text;
  for (const OptionText& option : command.options) {
    text += fmt::format("complete -c contactsim -n '{}'", when);
    for (const std::string& name : option.names)
      text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    text +=
        fmt::format("{} -d '{}'\n", option.value.empty() ? "" : fish_value(option), fish_text(option.help));
  }
  for (const OptionText& word : command.words)
    text += fmt::format("complete -c contactsim -n '{}'{} -d '{}'\n", when, fish_value(word),
                        fish_text(word.help));
  return text;
}

}  // namespace

ManualFile make_fish_completion(const CommandLineText& commands) {
  const std::string subcommands = subcommands_of(commands);
  std::string text = "# fish completion of contactsim, written by `contactsim manual fish`\n";
  for (const CommandText& command : commands) {
    if (!command.name.empty())
      text += fmt::format("complete -c contactsim -n __fish_use_subcommand -a {} -d '{}'\n", command.name,
                          fish_text(command.help));
  }
  for (const CommandText& command : commands) text += fish_command(command, subcommands);
  return {"fish/vendor_completions.d/contactsim.fish", text};
}

}  // namespace contactsim

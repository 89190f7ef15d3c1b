// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/manual/completion_values.hpp"
#include "app/manual/completions.hpp"

namespace contactsim {

namespace {

std::string bash_words_of(const OptionText& option) {
  switch (completion_of(option)) {
    case Completes::deck:
      return "_contactsim_files .i .inp";
    case Completes::mesh:
      return "_contactsim_files .g .e .exo .gen";
    case Completes::file:
      return "_contactsim_files ''";
    case Completes::folder:
      return "compgen -d -- \"$word\"";
    case Completes::words:
      return fmt::format("compgen -W '{}' -- \"$word\"", fmt::join(option.choices, " "));
    case Completes::phrases:
      return "compgen -W \"$_contactsim_phrases\" -- \"$word\"";
    case Completes::nothing:
      break;
  }
  return ":";
}

std::string bash_command(const CommandText& command) {
  std::string values;
  for (const OptionText& option : command.options) {
    if (!option.value.empty())
      values +=
          fmt::format("        {}) {} ; return ;;\n", fmt::join(option.names, "|"), bash_words_of(option));
  }
  std::string words;
  for (const OptionText& word : command.words) words += "      " + bash_words_of(word) + "\n";
  return fmt::format(
      "    {})\n      case $before in\n{}      esac\n"
      "      case $word in -*) compgen -W '{}' -- \"$word\" ; return ;; esac\n{}      ;;\n",
      command.name.empty() ? "''" : command.name, values, names_of(command.options), words);
}

constexpr const char* bash_end = R"(
# Files with these endings ('' for any) and folders, from which the way goes on.
_contactsim_files() {
  local ending file
  compgen -f -- "$word" | while IFS= read -r file; do
    if [ -d "$file" ]; then echo "$file/"; continue; fi
    for ending; do case $file in *"$ending") echo "$file"; break ;; esac; done
  done
}

_contactsim() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command='' line
  case " $_contactsim_commands " in *" ${COMP_WORDS[1]} "*) [ "$COMP_CWORD" -gt 1 ] && command=${COMP_WORDS[1]} ;; esac
  COMPREPLY=()
  while IFS= read -r line; do COMPREPLY+=("$line"); done < <({
    _contactsim_words
    case $word in -*) ;; *) [ "$COMP_CWORD" -gt 1 ] || compgen -W "$_contactsim_commands" -- "$word" ;; esac
  } | sort -u)
  case ${COMPREPLY[0]-} in */) compopt -o nospace 2>/dev/null ;; esac
}
complete -F _contactsim contactsim
)";

}  // namespace

ManualFile make_bash_completion(const CommandLineText& commands) {
  std::string text = fmt::format(
      "# bash completion of contactsim, written by `contactsim manual bash`\n"
      "_contactsim_commands='{}'\n_contactsim_phrases='{}'\n\n"
      "# What may stand for $word after $before, line by line.\n_contactsim_words() {{\n  case $command in\n",
      subcommands_of(commands), phrase_words());
  for (const CommandText& command : commands) text += bash_command(command);
  return {"bash-completion/completions/contactsim", text + "  esac\n}\n" + bash_end};
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/man_pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/manual/deck_sections.hpp"
#include "core/base/version.hpp"
#include "parser/row_reference.hpp"
#include "parser/text/phrases.hpp"

namespace contactsim {

namespace {

/// Text as troff should print it: hyphens that can be copied, no escape, no request at the start of a line.
std::string roff(std::string_view text) {
  std::string escaped;
  bool is_start = true;
  for (const char c : text) {
    if (is_start && (c == '.' || c == '\'')) escaped += "\\&";
    is_start = c == '\n';
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string begin_page(std::string_view name, int section, std::string_view what) {
  return fmt::format(".TH {} {} \"\" \"contactsim {}\"\n.SH NAME\n{} \\- {}\n", upper(name), section, version,
                     roff(name), roff(what));
}

std::string option_entry(const OptionText& option) {
  std::string names;
  for (const std::string& name : option.names)
    names += (names.empty() ? "" : ", ") + fmt::format("\\fB{}\\fR", roff(name));
  if (option.names.empty())
    return fmt::format(".TP\n\\fI{}\\fR\n{}\n", roff(option.value), roff(option.help));
  if (!option.value.empty()) names += fmt::format(" \\fI{}\\fR", roff(option.value));
  return fmt::format(".TP\n{}\n{}\n", names, roff(option.help));
}

std::string synopsis_of(const CommandText& command) {
  std::string text = ".B contactsim";
  if (!command.name.empty()) text += " " + command.name;
  text += "\n.RI [ options ]\n";
  for (const OptionText& word : command.words) {
    text += word.is_required ? fmt::format(".I {}\n", word.value) : fmt::format(".RI [ {} ]\n", word.value);
  }
  return text;
}

std::string entries_of(const CommandText& command) {
  std::string text;
  for (const OptionText& word : command.words) text += option_entry(word);
  for (const OptionText& option : command.options) text += option_entry(option);
  if (!command.footer.empty()) text += fmt::format(".PP\n.nf\n{}\n.fi\n", roff(command.footer));
  return text;
}

void add_labelled(std::string& text, std::string_view label, std::string_view value) {
  if (!value.empty()) text += fmt::format(".br\n{}: {}\n", label, roff(value));
}

std::string row_entry(const TreeRow& entry) {
  const RowReference row = reference_of(entry);
  std::string text = fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff(row.form), roff(row.help));
  add_labelled(text, "also", fmt::format("{}", fmt::join(row.spellings, ", ")));
  add_labelled(text, "names", fmt::format("{}", fmt::join(row.names, ", ")));
  add_labelled(text, "default", row.default_text == "none" ? "" : row.default_text);
  add_labelled(text, "choice", row.choice);
  if (entry.row->support != Support::supported) add_labelled(text, "support", row.support);
  if (entry.same_as != nullptr) add_labelled(text, "inside", "as in " + upper(entry.same_as->phrase));
  return text;
}

}  // namespace

ManualFile make_program_page(const CommandLineText& commands) {
  std::string text = begin_page("contactsim", 1, "explicit dynamics of solids, shells and beams in contact") +
                     ".SH SYNOPSIS\n";
  for (const CommandText& command : commands) text += synopsis_of(command) + ".br\n";
  text +=
      ".SH DESCRIPTION\n" + roff(commands.front().help) + "\n.SH OPTIONS\n" + entries_of(commands.front());
  for (const CommandText& command : commands) {
    if (command.name.empty()) continue;
    text += fmt::format(".SH {}\n{}.\n{}", upper(command.name), roff(command.help), entries_of(command));
  }
  text += ".SH SEE ALSO\n.BR contactsim\\-deck (5)\n";
  return {"man1/contactsim.1", text};
}

ManualFile make_deck_page() {
  std::string text =
      begin_page("contactsim-deck", 5, "the input deck of contactsim") +
      ".SH DESCRIPTION\nBlocks of a deck and the lines that may stand in them. A deck may also "
      "hold the inside of a region or of a contact definition alone.\n";
  for (const DeckSection& section : deck_sections()) {
    text += fmt::format(".SH {}\n", roff(upper(place_of(*section.rows.front()))));
    for (const TreeRow* row : section.rows) text += row_entry(*row);
  }
  text += ".SH SEE ALSO\n.BR contactsim (1)\n";
  return {"man5/contactsim-deck.5", text};
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "parser/row_reference.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace contactsim {

namespace {

std::string support_of(const RowText& row) {
  switch (row.support) {
    case Support::supported:
      return "supported";
    case Support::ignored:
      return "ignored: read, without effect";
    case Support::refused:
      return "refused: it would change the answer";
  }
  return "";
}

/// The rows that a row may be given in place of, and whether one of them must be.
std::string choice_of(const TreeRow& entry) {
  const RowText& row = *entry.row;
  if (!row.is_choice()) return "";
  const std::string phrases = phrases_of_choice(entry.around.back()->contents(), row.choice, "or");
  return fmt::format("{} of {}",
                     row.choice.lack.empty()     ? "at most one"
                     : row.choice.excess.empty() ? "at least one"
                                                 : "one",
                     phrases);
}

}  // namespace

std::string help_of(const RowText& row) {
  std::string help = row.help;
  if (!help.empty() && help[0] >= 'a' && help[0] <= 'z') help[0] = static_cast<char>(help[0] - 'a' + 'A');
  return help;
}

RowReference reference_of(const TreeRow& entry) {
  const RowText& row = *entry.row;
  RowReference reference;
  reference.form = deck_form_of(row);
  reference.help = help_of(row);
  reference.spellings = row.spellings;
  for (const NameKind kind : row.references) {
    const NameKindText& names = text_of(kind);
    reference.names.push_back(fmt::format("a {}{}", names.word, names.is_in_mesh ? " of the mesh" : ""));
  }
  reference.dimension = dimension_of(row);
  if (!row.is_block) reference.default_text = row.default_text;
  if (row.is_block && row.is_required) reference.default_text = "required";
  reference.choice = choice_of(entry);
  reference.support = support_of(row);
  return reference;
}

std::string place_of(const TreeRow& entry) {
  std::vector<std::string> phrases;
  for (const RowText* block : entry.around) phrases.push_back(block->phrase);
  return phrases.empty() ? "the deck's top level" : fmt::format("{}", fmt::join(phrases, " > "));
}

}  // namespace contactsim

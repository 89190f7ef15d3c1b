// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/manual/foreign_keywords.hpp"
#include "core/base/names.hpp"
#include "core/base/wrap_text.hpp"

namespace contactsim {

namespace {

/// Without stars, case and kinds of blanks, as a question may lack them.
std::string plain(std::string_view text) {
  std::string folded = fold(text);
  std::erase_if(folded, [](char c) { return c == '*' || c == ','; });
  return folded;
}

std::string describe(const ForeignKeyword& row) {
  std::string text = fmt::format("  {}", wrap_text(std::string(row.keyword), 2, 4));
  if (row.place != DeckPlace::none) text += fmt::format("    {}\n", to_string(row.place));
  std::string_view rest = row.lines;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    text += fmt::format("      {}\n", rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  if (!row.note.empty()) text += fmt::format("    {}", wrap_text(std::string(row.note), 4, 4));
  return text;
}

std::string describe_left_out() {
  std::string text = "left out, and why\n";
  for (const LeftOut& row : left_out_rows())
    text += fmt::format("  {}    {}", wrap_text(std::string(row.what), 2, 4),
                        wrap_text(std::string(row.why), 4, 4));
  return text;
}

std::string describe_program(std::string_view program) {
  std::string text =
      fmt::format("If you come from {}: what is written there, and what a deck has here\n", program);
  for (const ForeignKeyword& row : foreign_keywords()) {
    if (row.program == program) text += describe(row);
  }
  return text;
}

}  // namespace

std::string_view to_string(DeckPlace place) {
  switch (place) {
    case DeckPlace::sierra:
      return "at the top";
    case DeckPlace::region:
      return "in BEGIN PRESTO REGION";
    case DeckPlace::contact:
      return "in BEGIN CONTACT DEFINITION";
    case DeckPlace::surface_options:
      return "in BEGIN SURFACE OPTIONS";
    case DeckPlace::interaction_defaults:
      return "in BEGIN INTERACTION DEFAULTS";
    case DeckPlace::interaction:
      return "in BEGIN INTERACTION";
    case DeckPlace::results:
      return "in BEGIN RESULTS OUTPUT";
    case DeckPlace::heartbeat:
      return "in BEGIN HEARTBEAT OUTPUT";
    case DeckPlace::death:
      return "in BEGIN ELEMENT DEATH";
    case DeckPlace::none:
      break;
  }
  return "";
}

std::string explain_foreign_keywords(std::span<const std::string> words) {
  const std::string asked = plain(fmt::format("{}", fmt::join(words, " ")));
  constexpr std::string_view page = "coming_from";
  std::string text;
  if (asked.starts_with(page)) {
    for (const std::string_view program : foreign_programs()) {
      if (asked == page || asked == std::string(page) + "_" + fold(program))
        text += describe_program(program) + "\n";
    }
    return text.empty() ? text : text + describe_left_out();
  }
  for (const ForeignKeyword& row : foreign_keywords()) {
    if (!asked.empty() && plain(row.keyword).starts_with(asked))
      text += std::string(row.program) + "\n" + describe(row);
  }
  return text;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/decks/deck_harm.hpp"

#include <algorithm>

#include "campaigns/decks/deck_run.hpp"
#include "campaigns/decks/definition_harm.hpp"

namespace contactsim::test {

namespace {

bool is_one_line(const std::string& text) {
  return std::none_of(text.begin(), text.end(), [](char c) { return (c >= 0 && c < 0x20) || c == 0x7f; });
}

std::string harm_of_place(const DeckLocation& place) {
  const std::string& text = place.file->text;
  const auto n_lines = 1 + std::count(text.begin(), text.end(), '\n');
  if (place.line < 1 || place.line > n_lines) return "a place is in line " + std::to_string(place.line);
  const auto length = static_cast<int>(line_text(place).size());
  // The end of a line, and of one with a carriage return, are places, too.
  if (place.column < 1 || place.column > length + 2)
    return "a place is in column " + std::to_string(place.column) + " of " + std::to_string(length);
  return "";
}

std::string harm_of(const Diagnostic& problem) {
  if (problem.text.empty()) return "a problem has no text";
  if (!is_one_line(problem.text)) return "a text is not of one line: " + problem.text;
  if (!is_one_line(problem.hint)) return "a hint is not of one line: " + problem.hint;
  if (problem.severity == Severity::warning && problem.id.empty())
    return "a warning has no id: " + problem.text;
  if (problem.length < 1) return "a problem has no length: " + problem.text;
  if (!problem.location.is_known()) {
    return problem.text.starts_with("deck.i") ? "" : "a problem has no place: " + problem.text;
  }
  const std::string harm = harm_of_place(problem.location);
  return harm.empty() ? "" : harm + ": " + problem.text;
}

/// What a terminal shows of a deck: a line and some carets for each problem, its 20 first ones of a kind.
/// Loops and includes of the deck itself show a line more than once.
std::size_t max_messages(std::size_t deck_bytes) { return (std::size_t{1} << 20) + 1000 * deck_bytes; }

std::string harm_by_repeat(std::string_view text, const DeckRun& strict) {
  if (run_deck(text, false).messages != strict.messages) return "a second run says something else";
  const DeckRun lenient = run_deck(text, true);
  if (lenient.diagnostics.has_errors() && !strict.diagnostics.has_errors())
    return "a lenient run alone finds errors";
  for (const Diagnostic& problem : lenient.diagnostics.all()) {
    if (std::string harm = harm_of(problem); !harm.empty()) return harm;
  }
  return "";
}

}  // namespace

std::string find_deck_harm(std::string_view text, DeckLook look) {
  const DeckRun run = run_deck(text, false);
  for (const Diagnostic& problem : run.diagnostics.all()) {
    if (std::string harm = harm_of(problem); !harm.empty()) return harm;
  }
  if (run.messages.size() > max_messages(text.size()))
    return "its messages are " + std::to_string(run.messages.size()) + " bytes";
  if (!run.diagnostics.has_errors()) {
    if (std::string harm = find_definition_harm(run.definition); !harm.empty()) return harm;
  }
  return look == DeckLook::all ? harm_by_repeat(text, run) : "";
}

}  // namespace contactsim::test

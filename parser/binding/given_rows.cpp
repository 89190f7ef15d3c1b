// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/given_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "parser/text/phrases.hpp"

namespace contactsim {

void GivenRows::add(const std::vector<Word>& words, const MatchedItem& matched, Diagnostics& diagnostics) {
  const RowText& row = table_.rows[matched.row];
  const Word*& latest = latest_[matched.row];
  if (row.is_single && latest != nullptr) {
    diagnostics.add_warning("deck-repeated", words.front().location,
                            fmt::format("'{}' is given twice in one block, this one counts", row.phrase),
                            "the other stands at " + to_string(latest->location),
                            static_cast<int>(joined_words(words, matched.n_words).size()));
  }
  if (!words.empty()) latest = &words.front();
}

void GivenRows::check(DeckNames& names) const {
  std::vector<const Choice*> checked;
  for (const std::size_t i : table_.needed) {
    const RowText& row = table_.rows[i];
    if (row.is_required && latest_[i] == nullptr)
      names.add_problem_of_block("has no " + upper(row.phrase), "add " + deck_form_of(row));
    const bool is_checked = std::any_of(checked.begin(), checked.end(),
                                        [&](const Choice* choice) { return *choice == row.choice; });
    if (!row.is_choice() || is_checked) continue;
    checked.push_back(&row.choice);
    check_choice(row.choice, names);
  }
}

void GivenRows::check_choice(const Choice& choice, DeckNames& names) const {
  std::vector<const Word*> given;
  for (const std::size_t i : table_.needed) {
    if (latest_[i] != nullptr && table_.rows[i].choice == choice) given.push_back(latest_[i]);
  }
  if (given.empty() && !choice.lack.empty()) {
    names.add_problem_of_block(choice.lack, "give it " + phrases_of_choice(table_, choice, "or"));
  }
  if (given.size() < 2 || choice.excess.empty()) return;
  const auto is_before = [](const Word* a, const Word* b) { return a->location.line < b->location.line; };
  const auto [first, last] = std::minmax_element(given.begin(), given.end(), is_before);
  names.problems_of_block().add_error(
      (*last)->location, fmt::format("{} {}", names.block_for_message(), choice.excess),
      fmt::format("keep one of {}; the first stands at {}", phrases_of_choice(table_, choice, "and"),
                  to_string((*first)->location)),
      static_cast<int>((*last)->text.size()));
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/phrases.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/names.hpp"

namespace contactsim {

std::vector<std::string> split_phrase(std::string_view phrase) {
  std::vector<std::string> words(1);
  for (const char c : fold(phrase)) {
    if (c != '_') {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::string joined_words(const std::vector<Word>& words, std::size_t n) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < std::min(n, words.size()); ++i) texts.push_back(words[i].text);
  return fmt::format("{}", fmt::join(texts, " "));
}

std::string upper(std::string_view text) {
  std::string capitals(text);
  for (char& c : capitals) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return capitals;
}

std::size_t match_phrase(std::span<const std::string> phrase, std::span<const Word> words) {
  std::size_t matched = 0;
  for (std::size_t n = 0; n < words.size(); ++n) {
    if (words[n].kind != WordKind::bare) return 0;
    for (const std::string& part : split_phrase(words[n].text)) {
      if (matched == phrase.size() || part != phrase[matched]) return 0;
      ++matched;
    }
    if (matched == phrase.size()) return n + 1;
  }
  return 0;
}

PhraseIndex::PhraseIndex(std::span<const std::string> phrases) {
  for (const std::string& phrase : phrases) {
    phrases_.push_back(split_phrase(phrase));
    if (!phrases_.back().empty()) by_first_word_[phrases_.back().front()].push_back(phrases_.size() - 1);
  }
}

std::optional<PhraseIndex::Match> PhraseIndex::find(std::span<const Word> words) const {
  if (words.empty()) return std::nullopt;
  const auto parts = split_phrase(words.front().text);
  const auto rows = parts.empty() ? by_first_word_.end() : by_first_word_.find(parts.front());
  if (rows == by_first_word_.end()) return std::nullopt;
  std::optional<Match> longest;
  for (const std::size_t row : rows->second) {
    const std::size_t n = match_phrase(phrases_[row], words);
    const bool is_longer = !longest || phrases_[row].size() > phrases_[longest->phrase].size();
    if (n > 0 && is_longer) longest = Match{row, n};
  }
  return longest;
}

std::string PhraseIndex::nearest(std::span<const Word> words) const {
  std::vector<std::string> line;
  for (const Word& word : words) {
    if (word.kind != WordKind::bare) break;
    for (std::string& part : split_phrase(word.text)) line.push_back(std::move(part));
  }
  std::string best;
  double smallest = 1.0;
  for (const auto& phrase : phrases_) {
    const std::string known = fmt::format("{}", fmt::join(phrase, " "));
    const auto n = static_cast<std::ptrdiff_t>(std::min(phrase.size(), line.size()));
    const std::string typed = fmt::format("{}", fmt::join(line.begin(), line.begin() + n, " "));
    // The lengths alone may tell that they are too far apart: words may be as long as a deck.
    const double room = static_cast<double>(known.size()) + 1.0;
    const std::size_t gap = std::max(typed.size(), known.size()) - std::min(typed.size(), known.size());
    if (static_cast<double>(gap) / room > 0.34) continue;
    const double share = edit_distance(typed, known) / room;
    if (share < smallest && share <= 0.34) {
      smallest = share;
      best = known;
    }
  }
  return best;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace contactsim {

namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

char fold_character(char c) { return c == ' ' ? '_' : lower(c); }

}  // namespace

std::string fold(std::string_view name) {
  std::string text(name);
  for (char& c : text) c = fold_character(c);
  return text;
}

bool operator==(const DeckName& a, const DeckName& b) {
  return std::equal(a.text.begin(), a.text.end(), b.text.begin(), b.text.end(),
                    [](char x, char y) { return fold_character(x) == fold_character(y); });
}

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> before, last(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) now[j] = std::min(now[j], before[j - 2] + 1);
    }
    before = last;
    std::swap(last, now);
  }
  return last[b.size()];
}

std::optional<std::string> find_nearest(std::string_view word, std::span<const std::string> candidates) {
  // What is longer is no word that somebody mistyped, and distances take the product of both lengths.
  constexpr std::size_t longest = 256;
  if (word.size() > longest) return std::nullopt;
  const std::string folded = fold(word);
  const int limit = std::max(1, static_cast<int>(folded.size()) / 3);
  std::optional<std::string> nearest;
  int smallest = limit + 1;
  for (const std::string& candidate : candidates) {
    const int length_gap = std::abs(static_cast<int>(candidate.size()) - static_cast<int>(folded.size()));
    if (length_gap >= smallest) continue;
    const int distance = edit_distance(folded, fold(candidate));
    if (distance < smallest) {
      smallest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string suggest(std::string_view word, std::span<const std::string> candidates) {
  const auto nearest = find_nearest(word, candidates);
  return nearest ? fmt::format("did you mean '{}'?", *nearest) : "";
}

}  // namespace contactsim

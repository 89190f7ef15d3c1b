// SPDX-License-Identifier: BSD-3-Clause
#include "core/parallel/ranks.hpp"

#include <cstdlib>

namespace contactsim {

void Ranks::unite(std::span<std::uint8_t> marks) {
  if (!are_several()) return;
  constexpr std::size_t bits = 64;
  const std::size_t n_words = (marks.size() + bits - 1) / bits;
  std::vector<std::uint64_t> words(n_words * static_cast<std::size_t>(count_), 0);
  const auto word_of = [&](std::size_t rank, std::size_t i) -> std::uint64_t& {
    return words[rank * n_words + i / bits];
  };
  for (std::size_t i = 0; i < marks.size(); ++i)
    word_of(static_cast<std::size_t>(rank_), i) |= std::uint64_t{marks[i]} << i % bits;
  std::vector<std::size_t> begins;
  for (std::size_t rank = 0; rank <= static_cast<std::size_t>(count_); ++rank)
    begins.push_back(rank * n_words);
  gather_items(std::span(words), begins);
  for (std::size_t rank = 0; rank < static_cast<std::size_t>(count_); ++rank) {
    for (std::size_t i = 0; i < marks.size(); ++i) {
      if ((word_of(rank, i) >> i % bits & 1U) != 0) marks[i] = 1;
    }
  }
}

void OneRank::abort(int exit_code) { std::_Exit(exit_code); }

Ranks& one_rank() {
  static OneRank alone;
  return alone;
}

}  // namespace contactsim

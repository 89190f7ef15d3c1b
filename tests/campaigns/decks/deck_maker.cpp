// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/decks/deck_maker.hpp"

#include <algorithm>

#include "campaigns/decks/deck_syntax.hpp"
#include "parser/command_tree.hpp"

namespace contactsim::test {

namespace {

std::string deck_line(const RowText& row, const DeckSeeds& seeds, CaseRandom& random) {
  const std::string& phrase =
      row.spellings.empty() || random.once_in(2) ? row.phrase : random.pick(row.spellings);
  const std::string line = phrase + ' ' + draw_arguments(row.syntax, seeds, random);
  return row.is_block ? "begin " + line : line;
}

/// Some lines of one block of the command tables, within the blocks around it.
std::vector<std::string> draw_rows(const DeckSeeds& seeds, CaseRandom& random) {
  const std::vector<TreeRow>& tree = command_tree();
  const std::size_t chosen = random.below(tree.size());
  std::vector<std::string> lines;
  for (const RowText* block : tree[chosen].around) lines.push_back(deck_line(*block, seeds, random));
  for (std::size_t n = 1 + random.below(6), i = chosen; n > 0; --n) {
    lines.push_back(deck_line(*tree[i].row, seeds, random));
    if (tree[i].row->is_block && random.once_in(2)) lines.push_back("end");
    i = random.once_in(4) ? random.below(tree.size()) : std::min(i + random.below(4), tree.size() - 1);
  }
  for (std::size_t n = tree[chosen].around.size(); n > 0; --n) lines.push_back("end");
  return lines;
}

/// A line of a seed and what follows it in its block, within the blocks around it.
std::vector<std::string> draw_part(const DeckSeeds& seeds, CaseRandom& random) {
  const SeedDeck& deck = random.pick(seeds.decks);
  const std::size_t first = random.below(deck.lines.size());
  const std::size_t n = std::min(deck.lines.size() - first, 1 + random.below(12));
  std::vector<std::string> lines;
  for (const std::size_t head : deck.around[first]) lines.push_back(deck.lines[head]);
  lines.insert(lines.end(), deck.lines.begin() + static_cast<std::ptrdiff_t>(first),
               deck.lines.begin() + static_cast<std::ptrdiff_t>(first + n));
  for (std::size_t open = deck.around[first + n - 1].size(); open > 0; --open) lines.push_back("end");
  return lines;
}

std::vector<std::string> draw_mixed(const DeckSeeds& seeds, CaseRandom& random) {
  std::vector<std::string> lines;
  for (std::size_t n = 1 + random.below(8); n > 0; --n)
    lines.push_back(random.pick(random.pick(seeds.decks).lines));
  return lines;
}

}  // namespace

std::vector<std::string> draw_lines(const DeckSeeds& seeds, CaseRandom& random) {
  const std::size_t way = random.below(100);
  if (way < 40) return draw_rows(seeds, random);
  if (way < 75) return draw_part(seeds, random);
  if (way < 90) return draw_mixed(seeds, random);
  const std::vector<std::string>& whole = random.pick(seeds.decks).lines;
  // A long deck costs as much as fifty short ones.
  return whole.size() < 60 || random.once_in(16) ? whole : draw_part(seeds, random);
}

}  // namespace contactsim::test

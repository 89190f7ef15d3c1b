// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/decks/deck_seeds.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "core/base/names.hpp"
#include "parser/command_tree.hpp"

namespace contactsim::test {

namespace {

std::string read_all(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<std::filesystem::path> deck_paths(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() == ".i") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string first_word(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  words >> word;
  return fold(word);
}

SeedDeck make_seed(std::string_view text) {
  SeedDeck deck{split_lines(text), {}};
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < deck.lines.size(); ++i) {
    const std::string word = first_word(deck.lines[i]);
    if (word == "end" && !open.empty()) open.pop_back();
    deck.around.push_back(open);
    if (word == "begin") open.push_back(i);
  }
  return deck;
}

void add_words(const std::string& text, std::set<std::string>& words) {
  std::istringstream in(text);
  for (std::string word; in >> word;) words.insert(word);
}

}  // namespace

std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

DeckSeeds read_deck_seeds(const std::filesystem::path& repository) {
  DeckSeeds seeds;
  std::set<std::string> words;
  for (const char* folder : {"tests/campaigns/decks/corpus", "decks", "tests/app", "tests/package"}) {
    for (const std::filesystem::path& path : deck_paths(repository / folder)) {
      const std::string text = read_all(path);
      if (text.empty()) continue;
      seeds.decks.push_back(make_seed(text));
      add_words(text, words);
    }
  }
  for (const TreeRow& row : command_tree()) {
    add_words(row.row->phrase, words);
    for (const std::string& spelling : row.row->spellings) add_words(spelling, words);
  }
  seeds.words.assign(words.begin(), words.end());
  return seeds;
}

}  // namespace contactsim::test

// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/decks/deck_mutator.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "campaigns/decks/deck_maker.hpp"
#include "campaigns/decks/deck_syntax.hpp"

namespace contactsim::test {

namespace {

using Lines = std::vector<std::string>;

constexpr std::size_t max_bytes = 1 << 15;

constexpr std::array<const char*, 20> signs{"\"",   "'", "{", "}", "#",  "$",  "\\", "\\\n",         "=",
                                            ",",    "(", ")", ";", "\t", "\r", "\f", "\xef\xbb\xbf", "{{",
                                            "\xff", "%B"};

constexpr std::array<const char*, 40> aprepro{"{x}",
                                              "{x=1}",
                                              "{x = x + 1}",
                                              "{1/0}",
                                              "{-1^0.5}",
                                              "{10^400}",
                                              "{if(1)}",
                                              "{if(0)}",
                                              "{else}",
                                              "{elseif(1)}",
                                              "{endif}",
                                              "{ifdef(x)}",
                                              "{ifndef(x)}",
                                              "{loop(3)}",
                                              "{loop(1000000000)}",
                                              "{loop(-1)}",
                                              "{endloop}",
                                              "{loop(2,i_)}",
                                              "{switch(x)}",
                                              "{case(1)}",
                                              "{default}",
                                              "{endswitch}",
                                              "{include(\"self\")}",
                                              "{cinclude(\"self\")}",
                                              "includefile self",
                                              "include self",
                                              "{ECHO(OFF)}",
                                              "{ECHO(ON)}",
                                              "{VERBATIM(ON)}",
                                              "{VERBATIM(OFF)}",
                                              "{x ? 1 : 2}",
                                              "{\"a\" // 'b'}",
                                              "{sqrt(-1)}",
                                              "{rand(0,1)}",
                                              "{tostring(1e308)}",
                                              "{x++}",
                                              "{IO(",
                                              "{substr(\"abc\",0,99)}",
                                              "\\{",
                                              "{get_word(1,\"a b\",\" \")}"};

void erase_some(Lines& lines, CaseRandom& random) {
  const std::size_t at = random.below(lines.size()), n = 1 + random.below(3);
  lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(at),
              lines.begin() + static_cast<std::ptrdiff_t>(std::min(at + n, lines.size())));
}

void insert_line(Lines& lines, std::string line, CaseRandom& random) {
  lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(random.below(lines.size() + 1)), std::move(line));
}

void repeat_line(Lines& lines, CaseRandom& random) {
  const std::string line = random.pick(lines);
  for (std::size_t n = random.once_in(64) ? 400 : 1 + random.below(3); n > 0; --n)
    insert_line(lines, line, random);
}

void swap_lines(Lines& lines, CaseRandom& random) {
  const std::size_t a = random.below(lines.size()), b = random.below(lines.size());
  std::swap(lines[a], lines[b]);
}

void glue_lines(Lines& lines, CaseRandom& random) {
  const std::size_t at = random.below(lines.size());
  if (at + 1 == lines.size()) return;
  lines[at] += (random.once_in(2) ? " " : "") + lines[at + 1];
  lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(at + 1));
}

void nest_lines(Lines& lines, CaseRandom& random) {
  const std::string line = random.pick(lines);
  const std::size_t n = random.once_in(32) ? 1000 : 1 + random.below(20);
  lines.insert(lines.begin(), n, random.once_in(2) ? "begin " + line : "{if(1)}");
}

/// A word of a line: where it begins and ends.
struct WordPlace {
  std::size_t begin = 0, end = 0;
};

WordPlace draw_word(const std::string& line, CaseRandom& random) {
  std::vector<WordPlace> words;
  for (std::size_t begin = line.find_first_not_of(' '); begin != line.npos;) {
    const std::size_t end = std::min(line.find(' ', begin), line.size());
    words.push_back({begin, end});
    begin = line.find_first_not_of(' ', end);
  }
  return words.empty() ? WordPlace{} : random.pick(words);
}

std::string draw_nested(CaseRandom& random) {
  constexpr std::array<const char*, 6> open{"(", "{", "-", "!", "abs(", "\""};
  std::string text;
  const char* one = random.pick(open);
  for (std::size_t n = random.once_in(16) ? 3000 : 1 + random.below(40); n > 0; --n) text += one;
  return text;
}

std::string draw_text(const DeckSeeds& seeds, CaseRandom& random) {
  const std::size_t way = random.below(100);
  if (way < 30) return draw_number(random);
  if (way < 60) return random.pick(seeds.words);
  if (way < 75) return random.pick(signs);
  if (way < 93) return random.pick(aprepro);
  if (way < 96) return draw_nested(random);
  if (way < 99) return std::string(1, static_cast<char>(random.below(256)));
  return std::string(random.once_in(8) ? 20000 : 300, 'a');
}

void change_word(Lines& lines, const DeckSeeds& seeds, CaseRandom& random) {
  std::string& line = lines[random.below(lines.size())];
  const WordPlace place = draw_word(line, random);
  switch (random.below(6)) {
    case 0:
      line.erase(place.begin, place.end - place.begin);
      break;
    case 1:
      line.insert(place.end, ' ' + draw_text(seeds, random));
      break;
    case 2:
      line.insert(place.begin, line.substr(place.begin, place.end - place.begin) + ' ');
      break;
    default:
      line.replace(place.begin, place.end - place.begin, draw_text(seeds, random));
  }
}

void change_line(Lines& lines, const DeckSeeds& seeds, CaseRandom& random) {
  switch (random.below(9)) {
    case 0:
      return erase_some(lines, random);
    case 1:
      return repeat_line(lines, random);
    case 2:
      return swap_lines(lines, random);
    case 3:
      return glue_lines(lines, random);
    case 4:
      return insert_line(lines, random.pick(random.pick(seeds.decks).lines), random);
    case 5:
      return insert_line(lines, random.pick(aprepro), random);
    case 6:
      return insert_line(lines, random.once_in(2) ? "end" : "begin " + random.pick(seeds.words), random);
    case 7:
      return nest_lines(lines, random);
    default:
      lines.resize(1 + random.below(lines.size()));
  }
}

void change_bytes(std::string& text, const DeckSeeds& seeds, CaseRandom& random) {
  if (text.empty()) return;
  const std::size_t at = random.below(text.size());
  switch (random.below(5)) {
    case 0:
      text[at] = static_cast<char>(text[at] ^ 1 << random.below(8));
      break;
    case 1:
      text.insert(at, draw_text(seeds, random));
      break;
    case 2:
      text.erase(at, 1 + random.below(8));
      break;
    case 3:
      text.resize(at);
      break;
    default:
      text.insert(at, random.pick(signs));
  }
}

std::string join(const Lines& lines, const char* line_end) {
  std::string text;
  for (const std::string& line : lines) {
    if (text.size() + line.size() > max_bytes) break;
    text += line + line_end;
  }
  return text;
}

}  // namespace

std::string draw_deck(const DeckSeeds& seeds, CaseRandom& random) {
  Lines lines = draw_lines(seeds, random);
  for (std::size_t n = random.below(6); n > 0 && !lines.empty(); --n) {
    if (random.once_in(2)) {
      change_line(lines, seeds, random);
    } else {
      change_word(lines, seeds, random);
    }
  }
  std::string text = join(lines, random.once_in(16) ? "\r\n" : "\n");
  for (std::size_t n = random.once_in(4) ? 1 + random.below(4) : 0; n > 0; --n)
    change_bytes(text, seeds, random);
  return text;
}

}  // namespace contactsim::test

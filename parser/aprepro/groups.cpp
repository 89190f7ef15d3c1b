// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/groups.hpp"

#include <algorithm>
#include <array>

#include "core/base/names.hpp"

namespace contactsim {

namespace {

using Word = ApreproGroup::Word;
using Kind = ApreproNode::Kind;
using Test = ApreproBranch::Test;

/// How a control word is written. Words with an argument and the three that end or turn a construct are known
/// in any case, as decks write {Ifdef(x)} and {EndLoop}; the others only as listed, being likely names too.
struct Spelling {
  std::string_view word;
  std::string_view argument;  ///< "" none, "*" any, or the one that is meant
  Word meaning;
  bool any_case;
};

constexpr std::array<Spelling, 24> spellings = {{
    {"if", "*", Word::if_true, true},
    {"ifdef", "*", Word::if_defined, true},
    {"ifndef", "*", Word::if_undefined, true},
    {"elseif", "*", Word::else_if, true},
    {"else", "", Word::otherwise, true},
    {"endif", "", Word::end_if, true},
    {"switch", "*", Word::choose, true},
    {"case", "*", Word::one_case, true},
    {"default", "", Word::default_case, false},
    {"endswitch", "", Word::end_choose, false},
    {"loop", "*", Word::loop, true},
    {"endloop", "", Word::end_loop, true},
    {"include", "*", Word::include, true},
    {"cinclude", "*", Word::optional_include, true},
    {"ECHO", "", Word::echo_on, false},
    {"ECHO", "ON", Word::echo_on, false},
    {"ECHO", "OFF", Word::echo_off, false},
    {"NOECHO", "", Word::echo_off, false},
    {"IMMUTABLE", "ON", Word::immutable_on, false},
    {"IMMUTABLE", "OFF", Word::immutable_off, false},
    {"VERBATIM", "ON", Word::verbatim_on, false},
    {"VERBATIM", "OFF", Word::verbatim_off, false},
    {"APREPRO", "OFF", Word::verbatim_on, false},
    {"APREPRO", "ON", Word::verbatim_off, false},
}};

constexpr std::string_view blanks = " \t\f\r\n";

TextRange trimmed(std::string_view text, TextRange range) {
  const std::size_t begin = std::min(text.find_first_not_of(blanks, range.begin), range.end);
  std::size_t end = range.end;
  while (end > begin && blanks.find(text[end - 1]) != std::string_view::npos) --end;
  return {begin, end};
}

std::string_view part(std::string_view text, TextRange range) {
  return text.substr(range.begin, range.end - range.begin);
}

void find_word(std::string_view text, ApreproGroup& group) {
  const TextRange range = trimmed(text, group.inside);
  const std::string_view inside = part(text, range);
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto word_end = std::find_if_not(inside.begin(), inside.end(), is_letter);
  const std::string_view word = inside.substr(0, static_cast<std::size_t>(word_end - inside.begin()));
  constexpr std::size_t longest_word = 9;
  if (word.empty() || word.size() > longest_word) return;
  const TextRange rest = trimmed(text, {range.begin + word.size(), range.end});
  const bool has_argument = rest.end > rest.begin + 1 && text[rest.begin] == '(' && text[rest.end - 1] == ')';
  if (!has_argument && rest.end > rest.begin) return;
  const TextRange argument =
      has_argument ? TextRange{rest.begin + 1, rest.end - 1} : TextRange{rest.end, rest.end};
  const std::string folded = fold(word);
  for (const Spelling& spelling : spellings) {
    const bool is_word = spelling.any_case ? folded == spelling.word : word == spelling.word;
    const bool fits = spelling.argument == "*" ? has_argument
                                               : part(text, trimmed(text, argument)) == spelling.argument &&
                                                     has_argument == !spelling.argument.empty();
    if (!is_word || !fits) continue;
    group.word = spelling.meaning;
    group.argument = argument;
    return;
  }
}

}  // namespace

std::size_t skip_aprepro_string(std::string_view text, std::size_t at) {
  const std::size_t end = text.find_first_of(text[at] == '"' ? "\"\n" : "'", at + 1);
  const bool is_closed = end != std::string_view::npos && text[end] == text[at];
  return is_closed ? end + 1 : at + 1;
}

ApreproGroup read_aprepro_group(std::string_view text, std::size_t at) {
  ApreproGroup group;
  group.at = at;
  group.is_silent = text.substr(at).starts_with("{{");
  std::size_t i = at + (group.is_silent ? 2 : 1);
  group.inside.begin = i;
  while (i < text.size() && text[i] != '{' && text[i] != '}') {
    i = text[i] == '"' || text[i] == '\'' ? skip_aprepro_string(text, i) : i + 1;
  }
  group.inside.end = i;
  const std::string_view closing = group.is_silent ? "}}" : "}";
  group.is_closed = text.substr(i).starts_with(closing);
  const bool is_half_closed = i < text.size() && text[i] == '}';
  group.end = i + (group.is_closed ? closing.size() : is_half_closed ? 1 : 0);
  if (group.is_closed && !group.is_silent) find_word(text, group);
  return group;
}

std::optional<ApreproNode::Kind> construct_begun_by(Word word) {
  if (word == Word::if_true || word == Word::if_defined || word == Word::if_undefined)
    return Kind::conditional;
  if (word == Word::choose) return Kind::choice;
  return word == Word::loop ? std::optional(Kind::loop) : std::nullopt;
}

std::optional<ApreproNode::Kind> construct_ended_by(Word word) {
  if (word == Word::end_if) return Kind::conditional;
  if (word == Word::end_choose) return Kind::choice;
  return word == Word::end_loop ? std::optional(Kind::loop) : std::nullopt;
}

std::optional<ApreproNode::Kind> construct_split_by(Word word) {
  if (word == Word::else_if || word == Word::otherwise) return Kind::conditional;
  const bool is_case = word == Word::one_case || word == Word::default_case;
  return is_case ? std::optional(Kind::choice) : std::nullopt;
}

ApreproBranch::Test test_of(Word word) {
  if (word == Word::if_defined) return Test::is_defined;
  if (word == Word::if_undefined) return Test::is_undefined;
  if (word == Word::one_case) return Test::equals;
  const bool is_otherwise = word == Word::otherwise || word == Word::default_case;
  return is_otherwise ? Test::otherwise : Test::is_true;
}

const std::vector<std::string>& aprepro_control_words() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> list;
    for (const Spelling& spelling : spellings) {
      if (list.empty() || list.back() != spelling.word) list.emplace_back(spelling.word);
    }
    return list;
  }();
  return words;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/decks/deck_syntax.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace contactsim::test {

namespace {

constexpr std::array<const char*, 56> hostile_numbers{"0",
                                                      "-0",
                                                      "0.0",
                                                      "-1",
                                                      "1",
                                                      "2",
                                                      "3",
                                                      "0.5",
                                                      "1e308",
                                                      "-1e308",
                                                      "1e309",
                                                      "-1e309",
                                                      "1e-308",
                                                      "4.9e-324",
                                                      "1e-400",
                                                      "nan",
                                                      "NaN",
                                                      "-nan",
                                                      "inf",
                                                      "-inf",
                                                      "infinity",
                                                      "INF",
                                                      "nan(0x1)",
                                                      "0x10",
                                                      "0x1p3",
                                                      "0X1P-1074",
                                                      "2147483647",
                                                      "2147483648",
                                                      "-2147483648",
                                                      "4294967295",
                                                      "4294967296",
                                                      "9223372036854775807",
                                                      "9223372036854775808",
                                                      "-9223372036854775808",
                                                      "18446744073709551615",
                                                      "18446744073709551616",
                                                      "99999999999999999999999999",
                                                      "1e",
                                                      "1e+",
                                                      "1d3",
                                                      "1D-3",
                                                      "1.",
                                                      ".5",
                                                      ".",
                                                      "-.",
                                                      "+1",
                                                      "+-1",
                                                      "--1",
                                                      "1e1e1",
                                                      "1_000",
                                                      "1,000",
                                                      "1e99999999999",
                                                      "00000000000000000000001",
                                                      "0.1.2",
                                                      "1f",
                                                      "\xef\xbc\x91"};

constexpr std::array<const char*, 22> names{"a",
                                            "b",
                                            "block_1",
                                            "block_2",
                                            "surface_1",
                                            "nodelist_1",
                                            "steel",
                                            "f",
                                            "x",
                                            "all",
                                            "free surface",
                                            "1",
                                            "sierra_constant_function_one",
                                            "time",
                                            "A",
                                            "block_99999999999999999999",
                                            "on",
                                            "off",
                                            "begin",
                                            "end",
                                            "linear_elastic",
                                            "displacement"};

/// Takes a syntax apart from left to right.
class SyntaxDrawer {
 public:
  SyntaxDrawer(std::string_view syntax, const DeckSeeds& seeds, CaseRandom& random)
      : syntax_(syntax), seeds_(seeds), random_(random) {}

  /// Up to a bracket that closes what is not open here, or a bar.
  std::string draw_sequence();

 private:
  std::string draw_choice(char close);
  std::string draw_value();
  bool is_at(std::string_view signs) const {
    return at_ < syntax_.size() && signs.find(syntax_[at_]) != signs.npos;
  }

  std::string_view syntax_;
  const DeckSeeds& seeds_;
  CaseRandom& random_;
  std::size_t at_ = 0;
};

std::string SyntaxDrawer::draw_value() {
  const std::size_t end = std::min(syntax_.find('>', at_ + 2), syntax_.size());
  std::size_t last = end;
  if (syntax_.substr(at_, end - at_).find("real") != syntax_.npos || syntax_[at_ + 1] == 'i') {
    while (last + 1 < syntax_.size() && (syntax_[last + 1] == '=' || syntax_[last + 1] == ' ') &&
           syntax_.find('>', last + 1) < syntax_.find('<', last + 1))
      last = syntax_.find('>', last + 1);
  }
  const std::string_view name = syntax_.substr(at_, last - at_);
  at_ = std::min(last + 1, syntax_.size());
  const bool is_number = name.size() < 5 || name.find("real") != name.npos || name.find("int") != name.npos;
  if (is_number && !random_.once_in(32)) return draw_number(random_);
  return random_.once_in(4) ? random_.pick(seeds_.words) : names[random_.below(names.size())];
}

std::string SyntaxDrawer::draw_choice(char close) {
  std::vector<std::string> texts;
  do {
    ++at_;  // the bracket, or the bar
    texts.push_back(draw_sequence());
  } while (is_at("|"));
  if (is_at(std::string_view(&close, 1))) ++at_;
  if (close == ']' && random_.once_in(2)) return "";
  return random_.pick(texts);
}

std::string SyntaxDrawer::draw_sequence() {
  std::string text, last;
  while (at_ < syntax_.size() && !is_at("|]}")) {
    std::string piece;
    if (is_at("{[")) {
      piece = draw_choice(syntax_[at_] == '{' ? '}' : ']');
    } else if (is_at("<") && at_ + 1 < syntax_.size() && syntax_[at_ + 1] >= 'a') {
      piece = draw_value();
    } else if (syntax_.substr(at_).starts_with("...")) {
      at_ += 3;
      for (std::size_t n = random_.below(4); n > 0; --n) piece += ' ' + last;
    } else {
      piece = syntax_[at_++];
    }
    text += piece;
    if (piece.size() > 1) last = piece;
  }
  return text;
}

}  // namespace

std::string draw_number(CaseRandom& random) {
  if (random.once_in(2)) return std::to_string(random.below(12));
  return hostile_numbers[random.below(hostile_numbers.size())];
}

std::string draw_arguments(std::string_view syntax, const DeckSeeds& seeds, CaseRandom& random) {
  return SyntaxDrawer(syntax, seeds, random).draw_sequence();
}

}  // namespace contactsim::test

// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/line_grammar.hpp"

#include <boost/spirit/home/x3.hpp>
#include <cassert>
#include <functional>
#include <string>

namespace contactsim {

namespace {

namespace x3 = boost::spirit::x3;

/// What the semantic actions write to and the parser of quotes reads.
struct Progress {
  const LogicalLine& line;
  ParsedLine& parsed;
  std::size_t next_quote = 0;  ///< position in line.quotes
};

struct ProgressTag;

/// Matches a whole quoted string where the line reader has found one; where quotes open and close is decided
/// there alone.
struct QuotedString : x3::parser<QuotedString> {
  using attribute_type = x3::unused_type;

  template <class Iterator, class Context, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, x3::unused_type,
             Attribute&) const {
    x3::skip_over(first, last, context);
    Progress& progress = x3::get<ProgressTag>(context);
    const auto& quotes = progress.line.quotes;
    const auto at = static_cast<std::size_t>(first - progress.line.text.begin());
    while (progress.next_quote < quotes.size() && quotes[progress.next_quote].open < at)
      ++progress.next_quote;
    if (progress.next_quote == quotes.size() || quotes[progress.next_quote].open != at) return false;
    const std::size_t length = quotes[progress.next_quote].close + 1 - at;
    first += static_cast<std::ptrdiff_t>(length);
    return true;
  }
};

template <WordKind kind>
struct AddWord {
  template <class Context>
  void operator()(const Context& context) const {
    Progress& progress = x3::get<ProgressTag>(context);
    const auto& range = x3::_attr(context);
    const auto start = progress.line.text.begin();
    progress.parsed.words.push_back({static_cast<std::size_t>(range.begin() - start),
                                     static_cast<std::size_t>(range.end() - start), kind});
  }
};

template <ParsedLine::Kind kind>
struct SetKind {
  template <class Context>
  void operator()(const Context& context) const {
    Progress& progress = x3::get<ProgressTag>(context);
    progress.parsed.kind = kind;
    progress.parsed.keyword =
        static_cast<std::size_t>(x3::_attr(context).begin() - progress.line.text.begin());
  }
};

const auto separator = x3::char_(" \t,");
const auto symbol_character = x3::char_("=<>");
const auto word_end = separator | symbol_character | x3::eoi;
const auto final_colon = ':' >> &word_end;
const auto between_words = separator | final_colon;

const auto quoted = QuotedString{};
const auto symbol = x3::lit("<=") | ">=" | "==" | '<' | '>' | '=';
const auto character = x3::char_ - separator - symbol_character - final_colon;
// Groups do not nest and a broken one is no group, so that a long line of parentheses takes linear time.
const auto group = '(' >> *(x3::char_ - x3::char_("()")) >> ')';
const auto bare = character >> *(!quoted >> (group | character));

const auto word = x3::raw[quoted][AddWord<WordKind::quoted>{}] |
                  x3::raw[symbol][AddWord<WordKind::symbol>{}] | x3::raw[bare][AddWord<WordKind::bare>{}];
const auto begin_keyword = x3::raw[x3::no_case["begin"] >> &word_end][SetKind<ParsedLine::Kind::begin>{}];
const auto end_keyword = x3::raw[x3::no_case["end"] >> &word_end][SetKind<ParsedLine::Kind::end>{}];
const auto line_rule = *between_words >> -(begin_keyword | end_keyword) >> *between_words >>
                       *(word >> *between_words) >> x3::eoi;

}  // namespace

void parse_line(const LogicalLine& line, ParsedLine& parsed) {
  parsed.kind = ParsedLine::Kind::command;
  parsed.keyword = 0;
  parsed.words.clear();
  Progress progress{line, parsed};
  auto first = line.text.begin();
  [[maybe_unused]] const bool is_parsed =
      x3::parse(first, line.text.end(), x3::with<ProgressTag>(std::ref(progress))[line_rule]);
  assert(is_parsed && "every character belongs to a word or between two");
}

}  // namespace contactsim

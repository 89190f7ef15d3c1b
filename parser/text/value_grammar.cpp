// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/value_grammar.hpp"

#include <algorithm>
#include <boost/fusion/include/std_tuple.hpp>
#include <boost/spirit/home/x3.hpp>
#include <tuple>
#include <type_traits>
#include <utility>

#include "parser/text/phrases.hpp"
#include "parser/text/word_grammar.hpp"

namespace contactsim {

namespace x3 = boost::spirit::x3;

/// Phrases and their positions in the list of them. Every keyword ends in a blank.
struct PhraseTable {
  x3::symbols<std::size_t> positions;
  std::size_t longest = 0;  ///< number of characters
};

namespace {

using Iterator = Words::iterator;

/// One word that is no symbol, if `find` finds a value in its text.
template <auto find>
struct WrittenParser : x3::parser<WrittenParser<find>> {
  using attribute_type = typename std::invoke_result_t<decltype(find), std::string_view>::value_type;
  static constexpr bool has_attribute = true;

  template <class Context, class RuleContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&, Attribute& value) const {
    if (first == last || first->kind == WordKind::symbol) return false;
    const auto found = find(first->text);
    if (!found) return false;
    x3::traits::move_to(*found, value);
    ++first;
    return true;
  }
};

/// One word that is no symbol, and where it stands.
struct NameParser : x3::parser<NameParser> {
  using attribute_type = DeckName;
  [[maybe_unused]] static constexpr bool has_attribute = true;

  template <class Context, class RuleContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&, Attribute& name) const {
    if (first == last || first->kind == WordKind::symbol) return false;
    x3::traits::move_to(DeckName{first->text, first->location}, name);
    ++first;
    return true;
  }
};

/// One word of a kind that its rule over characters matches from its first character to its last.
template <class Subject>
struct SpelledParser : x3::unary_parser<Subject, SpelledParser<Subject>> {
  using attribute_type = x3::unused_type;
  static constexpr bool has_attribute = false;

  constexpr SpelledParser(WordKind word_kind, const Subject& characters)
      : x3::unary_parser<Subject, SpelledParser<Subject>>(characters), kind(word_kind) {}

  template <class Context, class RuleContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&, Attribute&) const {
    if (first == last || first->kind != kind) return false;
    auto character = first->text.begin();
    if (!x3::parse(character, first->text.end(), this->subject)) return false;
    if (character != first->text.end()) return false;
    ++first;
    return true;
  }

  WordKind kind;
};

template <class Characters>
constexpr auto spelled(WordKind kind, const Characters& characters) {
  using Subject = typename x3::extension::as_parser<Characters>::value_type;
  return SpelledParser<Subject>(kind, x3::as_parser(characters));
}

auto keyword(std::string_view text) {
  return spelled(WordKind::bare, x3::no_case[x3::lit(std::string(text))]);
}

/// The keywords of a phrase as PhraseTable holds them.
std::string spell(std::string_view phrase) {
  std::string keywords;
  for (const std::string& keyword : split_phrase(phrase)) keywords += keyword + ' ';
  return keywords;
}

/// The bare words of the longest phrase of a table that fits: its position.
struct PhraseParser : x3::parser<PhraseParser> {
  using attribute_type = std::size_t;
  [[maybe_unused]] static constexpr bool has_attribute = true;

  explicit PhraseParser(const PhraseTable& phrases) : table(phrases) {}

  template <class Context, class RuleContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&, Attribute& position) const {
    std::string keywords;
    const std::size_t* longest = nullptr;
    for (Iterator word = first; word != last && word->kind == WordKind::bare;) {
      const std::string more = spell(word->text);
      ++word;
      if (more.empty()) continue;
      keywords += more;
      if (keywords.size() > table.longest) break;
      const std::size_t* found = table.positions.find(keywords);
      if (found == nullptr) continue;
      longest = found;
      first = word;
    }
    if (longest != nullptr) x3::traits::move_to(*longest, position);
    return longest != nullptr;
  }

  const PhraseTable& table;
};

// Rules: their names say what is expected where they do not fit.
const auto real = x3::rule<struct RealTag, double>{"a number"} = WrittenParser<find_real>{};
const auto integer = x3::rule<struct IntegerTag, std::int64_t>{"an integer"} = WrittenParser<find_integer>{};
const auto name = x3::rule<struct NameTag, DeckName>{"a name"} = NameParser{};
const auto vector = x3::expect[real] >> x3::expect[real] >> x3::expect[real];
const auto reals = x3::expect[real] % !x3::eoi;
const auto integers = x3::expect[integer] % !x3::eoi;
const auto names = x3::expect[name] % !x3::eoi;
const auto separator = spelled(WordKind::symbol, '=') | keyword("is") | keyword("are");

/// What the rule makes of the front of `words`.
template <class V, class Rule>
V take(Words& words, const Rule& rule) {
  V value{};
  auto first = words.begin();
  try {
    x3::parse(first, words.end(), x3::expect[rule], value);
  } catch (const x3::expectation_failure<Iterator>& failure) {
    words = {failure.where(), words.end()};
    throw ValueError{failure.which()};
  }
  words = {first, words.end()};
  return value;
}

/// The same where the words need not fit; returns whether they do.
template <class Rule, class... Attribute>
bool take_if_next(Words& words, const Rule& rule, Attribute&... attribute) {
  auto first = words.begin();
  const bool is_next = x3::parse(first, words.end(), rule, attribute...);
  words = {first, words.end()};
  return is_next;
}

}  // namespace

double take_real(Words& words) { return take<double>(words, real); }
std::int64_t take_integer(Words& words) { return take<std::int64_t>(words, integer); }
DeckName take_name(Words& words) { return take<DeckName>(words, name); }

Eigen::Vector3d take_vector(Words& words) {
  const auto [x, y, z] = take<std::tuple<double, double, double>>(words, vector);
  return {x, y, z};
}

std::vector<double> take_reals(Words& words) { return take<std::vector<double>>(words, reals); }

std::vector<std::int64_t> take_integers(Words& words) {
  return take<std::vector<std::int64_t>>(words, integers);
}

std::vector<DeckName> take_names(Words& words) { return take<std::vector<DeckName>>(words, names); }

bool take_separator(Words& words) { return take_if_next(words, separator); }

bool take_keyword(Words& words, std::string_view text) { return take_if_next(words, keyword(text)); }

Choices::Choices(std::vector<std::string> phrases) : phrases_(std::move(phrases)) {
  PhraseTable table;
  for (std::size_t i = 0; i < phrases_.size(); ++i) {
    const std::string keywords = spell(phrases_[i]);
    table.positions.add(keywords, i);
    table.longest = std::max(table.longest, keywords.size());
  }
  table_ = std::make_shared<const PhraseTable>(std::move(table));
}

std::optional<std::size_t> take_choice(Words& words, const Choices& choices) {
  std::size_t position = 0;
  if (!take_if_next(words, PhraseParser(choices.table()), position)) return std::nullopt;
  return position;
}

}  // namespace contactsim

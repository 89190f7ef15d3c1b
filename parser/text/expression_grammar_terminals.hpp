// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/spirit/home/x3.hpp>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/functions/expression_operators.hpp"
#include "parser/text/expression_writer.hpp"

/// What the grammar of expressions is put together from: the dialects, their operators and sets of characters
/// as parsers, and semantic actions. For expression_grammar.cpp alone.
namespace contactsim::expression_terminals {

namespace x3 = boost::spirit::x3;

using Dialects = ExpressionDialects;
using Level = ExpressionLevel;
using Iterator = std::string_view::const_iterator;

/// The rows of one symbol.
struct SymbolRows {
  const ExpressionOperator* prefix = nullptr;  ///< before a value
  const ExpressionOperator* infix = nullptr;   ///< behind a value or a name
};

/// What differs from dialect to dialect.
struct Dialect {
  Dialects which;
  std::string_view name_marks;  ///< what names hold besides letters, digits and _
  std::string_view quotes;
  std::string_view separators;  ///< of arguments
  std::string_view marks;       ///< tokens of one character, besides operators
  const char* end;              ///< what may follow an expression
  const char* end_hint;
  x3::symbols<SymbolRows> symbols = {};  ///< operators; the longest that fits stands there
};

inline const Dialect& find_dialect(Dialects which) {
  static const auto add_operators = [](Dialect dialect) {
    for (const ExpressionOperator& row : expression_operators()) {
      if (!has_dialect(row.dialects, dialect.which)) continue;
      SymbolRows& rows = dialect.symbols.at(std::string(row.symbol));
      (row.level == Level::prefix ? rows.prefix : rows.infix) = &row;
    }
    return dialect;
  };
  static const Dialect function =
      add_operators({Dialects::function, ".", "", ",", "(),;:?", "the end of the expression", ""});
  static const Dialect aprepro = add_operators(
      {Dialects::aprepro, ":", "\"'", ",;", "(),;:?]", "'}'", "one expression per pair of braces"});
  return which == Dialects::aprepro ? aprepro : function;
}

/// What the semantic actions write to and the terminals read.
struct Progress {
  const Dialect& dialect;
  ExpressionWriter writer;
};

struct ProgressTag;

/// An operator of the dialect, of some levels.
struct OperatorParser : x3::parser<OperatorParser> {
  using attribute_type = OperatorToken;
  static constexpr bool has_attribute = true;

  constexpr OperatorParser(const ExpressionOperator* SymbolRows::*place, Level from, Level to)
      : rows(place), lowest(from), highest(to) {}

  template <class Context, class RuleContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&,
             Attribute& token) const {
    x3::skip_over(first, last, context);
    const Progress& progress = x3::get<ProgressTag>(context);
    Iterator end = first;
    const SymbolRows* found = progress.dialect.symbols.prefix_find(end, last);
    const ExpressionOperator* row = found != nullptr ? found->*rows : nullptr;
    if (row == nullptr || row->level < lowest || row->level > highest) return false;
    x3::traits::move_to(OperatorToken{{first, end}, row}, token);
    first = end;
    return true;
  }

  const ExpressionOperator* SymbolRows::*rows;
  Level lowest, highest;
};

constexpr OperatorParser operator_at(Level lowest, Level highest) {
  return {&SymbolRows::infix, lowest, highest};
}

/// A character out of a set of the dialect.
struct CharacterParser : x3::parser<CharacterParser> {
  using attribute_type = x3::unused_type;
  static constexpr bool has_attribute = false;

  explicit constexpr CharacterParser(std::string_view Dialect::*set) : characters(set) {}
  template <class Context, class RuleContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&, Attribute&) const {
    x3::skip_over(first, last, context);
    const Progress& progress = x3::get<ProgressTag>(context);
    const bool fits = first != last && (progress.dialect.*characters).find(*first) != std::string_view::npos;
    if (fits) ++first;
    return fits;
  }

  std::string_view Dialect::*characters;
};

template <class Attribute>
decltype(auto) token_of(const Attribute& attribute) {
  if constexpr (std::is_same_v<Attribute, OperatorToken>) {
    return attribute;
  } else {
    return std::string_view(attribute.begin(), attribute.end());
  }
}

/// A semantic action: a member function of ExpressionWriter, which is given the token if it takes one.
template <auto member>
struct Write {
  template <class Context>
  void operator()(const Context& context) const {
    Progress& progress = x3::get<ProgressTag>(context);
    if constexpr (std::is_invocable_v<decltype(member), ExpressionWriter&>) {
      (progress.writer.*member)();
    } else {
      (progress.writer.*member)(token_of(x3::_attr(context)));
    }
  }
};

template <auto member>
constexpr Write<member> write{};

}  // namespace contactsim::expression_terminals

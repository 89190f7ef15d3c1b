// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/expression_grammar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/spirit/home/x3.hpp>
#include <functional>
#include <utility>

#include "parser/text/expression_grammar_terminals.hpp"
#include "parser/text/expression_writer.hpp"

namespace contactsim {

namespace {

namespace x3 = boost::spirit::x3;
using namespace expression_terminals;

using W = ExpressionWriter;

[[noreturn]] void fail_at_character(const ExpressionWriter& writer, std::string_view rest) {
  if (rest[0] == '[' || rest[0] == ']') {
    writer.fail(rest.substr(0, 1), "components in brackets are not supported",
                "a vector variable v has the components v_x v_y v_z");
  }
  const bool is_printable = rest[0] > ' ' && rest[0] < 0x7f;
  writer.fail(rest.substr(0, 1), is_printable ? fmt::format("unexpected '{}' in an expression", rest[0])
                                              : fmt::format("unexpected character {:#04x} in an expression",
                                                            static_cast<unsigned char>(rest[0])));
}

const auto fail_unclosed = [](const auto& context) {
  const Progress& progress = x3::get<ProgressTag>(context);
  const std::string_view quote = token_of(x3::_attr(context));
  progress.writer.fail(quote, fmt::format("the string {} is never closed", quote),
                       quote == "\"" ? "only a string in '...' may span lines" : "");
};

const auto fail_array = [](const auto& context) {
  const Progress& progress = x3::get<ProgressTag>(context);
  if (progress.dialect.which == Dialects::function)
    fail_at_character(progress.writer, token_of(x3::_attr(context)));
  progress.writer.fail(progress.writer.kept_name(), "arrays are not supported");
};

const auto fail_empty = [](const auto& context) {
  const Progress& progress = x3::get<ProgressTag>(context);
  progress.writer.fail(token_of(x3::_attr(context)), "the expression is empty");
};

// Tokens.
const auto quote = CharacterParser(&Dialect::quotes);
// x3::digit must not see other characters than those of ASCII.
const auto digit = x3::char_("0-9");
const auto name_start = x3::char_("a-zA-Z_");
const auto name =
    x3::raw[x3::lexeme[name_start >> *(name_start | digit | CharacterParser(&Dialect::name_marks))]];
const auto fraction = '.' >> +digit;
const auto exponent = x3::char_("eE") >> -x3::char_("+-") >> +digit;
const auto number = x3::raw[x3::lexeme[(+digit >> -('.' >> *digit) | fraction) >> -exponent]];
const auto string =
    x3::raw[x3::lexeme[('"' >> *~x3::char_("\"\n") >> '"') | ('\'' >> *~x3::char_('\'') >> '\'')]];
const auto unclosed = x3::raw[x3::char_("\"'")][fail_unclosed];
const auto prefix = OperatorParser(&SymbolRows::prefix, Level::prefix, Level::prefix);
const auto binary = operator_at(Level::logical_or, Level::concatenation);
const auto definition = operator_at(Level::definition, Level::definition);
const auto assignment = operator_at(Level::assignment, Level::assignment);
const auto step = operator_at(Level::step, Level::step);
const auto bracket = operator_at(Level::bracket, Level::bracket);
const auto separator = CharacterParser(&Dialect::separators);

// Rules: what their names say is expected where they do not fit.
const x3::rule<struct ValueTag> value = "a value";
const x3::rule<struct ExpressionTag> expression = "an expression";

const auto arguments =
    x3::raw[x3::lit('(')][write<&W::open_call>] >>
    (x3::lit(')') | (expression[write<&W::end_argument>] % separator > ')')) >> x3::eps[write<&W::close>];
const auto step_behind = step[write<&W::keep_step>] >> x3::eps[write<&W::step_behind_name>];
const auto named = name[write<&W::keep_name>] >>
                   (arguments | step_behind | x3::raw[x3::lit('[')][fail_array] |
                    x3::eps[write<&W::add_name>]);
const auto group =
    x3::raw[x3::lit('(')][write<&W::open_group>] > expression > ')' > x3::eps[write<&W::close>];
const auto truncation = bracket[write<&W::open_bracket>] > expression > ']' > x3::eps[write<&W::close>];
const auto step_target = x3::rule<struct StepTargetTag>{"a name for '++' or '--'"} =
    name[write<&W::step_name>] | number[write<&W::step_number>];
const auto stepped = step[write<&W::keep_step>] > step_target;
const auto quoted = &quote >> (string[write<&W::add_string>] | unclosed);

const auto value_def = number[write<&W::add_number>] | quoted | named | group | truncation | stepped;
const auto before_value =
    prefix[write<&W::add_prefix>] | (name[write<&W::keep_name>] >> assignment[write<&W::add_assignment>]);
const auto operand = *before_value > value;
const auto choice = x3::raw[x3::lit('?')][write<&W::open_choice>] > expression >
                    x3::raw[x3::lit(':')][write<&W::split_choice>] > expression > x3::eps[write<&W::close>];
const auto expression_def =
    (operand >> *(binary[write<&W::add_binary>] > operand) >> -choice) >> x3::eps[write<&W::end_expression>];
BOOST_SPIRIT_DEFINE(value, expression)

const auto statement = -(name[write<&W::keep_name>] >> definition[write<&W::add_assignment>]) > expression;
const auto between_statements = x3::raw[+x3::lit(';') >> !x3::eoi][write<&W::end_statement>];
const auto statements = (*x3::lit(';') >> -x3::raw[x3::eoi][fail_empty] >> statement >>
                         *(between_statements > statement) >> *x3::lit(';')) > x3::eoi;
const auto aprepro_expression = expression > x3::eoi;

const auto blank = x3::char_(" \t\n\r\f");

/// The token that `rest` begins with. Throws ExpressionError when there is none.
std::string_view token_at(Progress& progress, std::string_view rest) {
  auto end = rest.begin();
  const auto token = number | name | (&quote >> (string | unclosed));
  const bool is_token = x3::phrase_parse(end, rest.end(), x3::with<ProgressTag>(std::ref(progress))[token],
                                         blank, x3::skip_flag::dont_post_skip) ||
                        progress.dialect.symbols.prefix_find(end, rest.end()) != nullptr;
  if (is_token) return {rest.begin(), end};
  if (progress.dialect.marks.find(rest[0]) == std::string_view::npos)
    fail_at_character(progress.writer, rest);
  return rest.substr(0, 1);
}

/// Throws the error of what does not fit at the beginning of `rest`.
[[noreturn]] void fail_expected(Progress& progress, std::string_view rest, const std::string& expected) {
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t\n\r\f"), rest.size()));
  const std::string_view token = rest.empty() ? rest : token_at(progress, rest);
  const std::string found = rest.empty() ? "the end of the expression" : fmt::format("'{}'", token);
  const ExpressionWriter& writer = progress.writer;
  if (expected == value.name || expected == step_target.name)
    writer.fail(token, fmt::format("expected {}, found {}", expected, found));
  const std::string_view open = writer.innermost();
  if (open.empty()) {
    writer.fail(token, fmt::format("expected an operator or {}, found {}", progress.dialect.end, found),
                progress.dialect.end_hint);
  }
  const char closing = open == "(" ? ')' : open == "[" ? ']' : ':';
  const bool may_be_in_name = progress.dialect.name_marks[0] == closing;
  writer.fail(token, fmt::format("expected '{}' for this '{}', found {}", closing, open, found),
              may_be_in_name ? "a name may hold ':', so put a blank before it" : "");
}

template <class Rule>
void parse(Progress& progress, std::string_view text, const Rule& rule) {
  auto first = text.begin();
  try {
    x3::phrase_parse(first, text.end(), x3::with<ProgressTag>(std::ref(progress))[rule], blank);
  } catch (const x3::expectation_failure<Iterator>& failure) {
    fail_expected(progress, {failure.where(), text.end()}, failure.which());
  }
}

}  // namespace

std::vector<ExpressionItem> parse_expression(std::string_view text, ExpressionDialects dialect,
                                             std::size_t base) {
  const bool is_function = dialect == Dialects::function;
  Progress progress{find_dialect(dialect), {text, base, is_function}};
  if (is_function) {
    parse(progress, text, statements);
  } else {
    parse(progress, text, aprepro_expression);
  }
  return progress.writer.take_items();
}

DeckExpression read_deck_expression(DeckLocation location, std::string text) {
  DeckExpression read{std::move(location), std::move(text)};
  try {
    read.items = parse_expression(read.text, Dialects::function);
  } catch (const ExpressionError& error) {
    read.error = error;
  }
  return read;
}

bool is_aprepro_name(std::string_view text) {
  auto first = text.begin();
  return x3::parse(first, text.end(), name_start >> *(name_start | digit | ':') >> x3::eoi);
}

}  // namespace contactsim

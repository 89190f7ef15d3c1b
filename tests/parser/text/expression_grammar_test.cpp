// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/expression_grammar.hpp"

#include <fmt/format.h>

#include <string>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

constexpr auto function = ExpressionDialects::function;
constexpr auto aprepro = ExpressionDialects::aprepro;

std::string show(const ExpressionItem& item) {
  using Kind = ExpressionItem::Kind;
  switch (item.kind) {
    case Kind::number:
      return fmt::format("{}", item.number);
    case Kind::string:
      return '"' + item.text + '"';
    case Kind::call:
      return fmt::format("{}({})", item.text, item.n_arguments);
    case Kind::prefix:
      return item.text + "_";
    case Kind::store:
      return ">" + item.text;
    case Kind::drop:
      return "drop";
    case Kind::copy:
      return "copy";
    case Kind::swap:
      return "swap";
    case Kind::otherwise:
      return ":";
    case Kind::choose:
      return "?";
    case Kind::chosen:
      return "end";
    case Kind::name:
    case Kind::binary:
      break;
  }
  return item.text;
}

std::string postfix(std::string_view text, ExpressionDialects dialect) {
  std::string shown;
  for (const ExpressionItem& item : parse_expression(text, dialect)) {
    shown += (shown.empty() ? "" : " ") + show(item);
  }
  return shown;
}

}  // namespace

TEST_CASE("both dialects put expressions into postfix order alike", "[parser][expression]") {
  const auto [text, expected] = GENERATE(table<std::string, std::string>({
      {"1 + 2*3 - x", "1 2 3 * + x -"},
      {"(1 + 2)*3", "1 2 + 3 *"},
      {"-x^2*y", "x 2 ^ -_ y *"},
      {"2^-x*y", "2 x -_ ^ y *"},
      {"!a + b < 3", "a !_ b + 3 <"},
      {"a || b && c", "a b c && ||"},
      {"f(x, g(), -1)/2", "x g(0) 1 -_ f(3) 2 /"},
      {"a ? b : c ? d : e + 1", "a ? b : c ? d : e 1 + end end"},
      {"1 + (a ? b ? c : d : e)", "1 a ? b ? c : d end : e end +"},
  }));
  INFO(text);
  CHECK(postfix(text, function) == expected);
  CHECK(postfix(text, aprepro) == expected);
}

TEST_CASE("statements of functions leave the value of the last one", "[parser][expression]") {
  CHECK(postfix(";a = 2*x;; a.b = a ? 1 : 2; a;", function) == "2 x * >a drop a ? 1 : 2 end >a.b drop a");
}

TEST_CASE("assignments of Aprepro reach as far to the right as they can", "[parser][expression]") {
  const auto [text, expected] = GENERATE(table<std::string, std::string>({
      {"1 + a = b = 2 + 3", "1 2 3 + >b >a +"},
      {"(a = 1) + 2", "1 >a 2 +"},
      {"a = b ? 1 : 2", "b ? 1 : 2 end >a"},
      {"- x:y = 3", "3 >x:y -_"},
      {"a **= 2 + b", "2 b + a swap **= >a"},
      {"++a + a--", "a 1 ++ >a a copy 1 -- >a drop +"},
      {"--3", "3 1 --"},
  }));
  INFO(text);
  CHECK(postfix(text, aprepro) == expected);
}

TEST_CASE("operators of Aprepro alone have their places among the others", "[parser][expression]") {
  CHECK(postfix("2 ^ 3 ** -4 ^ 5", aprepro) == "2 3 4 5 ^ -_ ** ^");
  CHECK(postfix("2 * 3 ~ 4", aprepro) == "2 3 * 4 ~");
  CHECK(postfix("[x + 1] * 2", aprepro) == "x 1 + [_ 2 *");
  CHECK(postfix("'a\nb' // \"c\" // -d // e == f", aprepro) == "\"a\nb\" \"c\" // d e // -_ // f ==");
  CHECK(postfix("'\xc3\xa4' // \"\xff\"", aprepro) == "\"\xc3\xa4\" \"\xff\" //");
  CHECK(postfix("f(1; 2, 3)", aprepro) == "1 2 3 f(3)");
}

TEST_CASE("items stand where their names and operators do", "[parser][expression]") {
  const auto items = parse_expression("ab *= f( 2 )", aprepro, 100);
  REQUIRE(items.size() == 6);
  CHECK(items[0].offset == 109);  // 2
  CHECK(items[1].offset == 106);  // f
  CHECK(items[2].offset == 100);  // ab
  CHECK(items[4].offset == 103);  // *=
  CHECK(items[5].offset == 100);
}

TEST_CASE("a mistake in an expression of the deck is kept", "[parser][expression]") {
  const DeckExpression wrong = read_deck_expression({}, "1 + ");
  CHECK(wrong.text == "1 + ");
  CHECK(wrong.items.empty());
  REQUIRE(wrong.error.has_value());
  CHECK(wrong.error->offset == 4);
  CHECK_FALSE(read_deck_expression({}, "1 + x").error.has_value());
}

TEST_CASE("names of Aprepro hold letters, digits, _ and colons", "[parser][expression]") {
  for (const char* name : {"a", "_", "x:1", "A_b:C9"}) CHECK(is_aprepro_name(name));
  for (const char* other : {"", "1a", ":a", "a.b", "a b", "a+"}) CHECK_FALSE(is_aprepro_name(other));
}

// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/expression_writer.hpp"

#include <algorithm>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

using ItemKind = ExpressionItem::Kind;

/// Hands the parts of a text to a writer as the grammar would.
struct Written {
  explicit Written(std::string written, std::size_t base = 0, bool is_strict = true)
      : text(std::move(written)), writer(text, base, is_strict) {}

  std::string_view part(std::string_view of) const {
    const std::size_t at = text.find(of);
    REQUIRE(at != std::string::npos);
    return std::string_view(text).substr(at, of.size());
  }
  OperatorToken token(std::string_view symbol, bool is_prefix = false) const {
    const auto rows = expression_operators();
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const ExpressionOperator& one) {
      return one.symbol == symbol && (one.level == ExpressionLevel::prefix) == is_prefix;
    });
    REQUIRE(row != rows.end());
    return {part(symbol), &*row};
  }
  void number(std::string_view of) { writer.add_number(part(of)); }
  void name(std::string_view of) {
    writer.keep_name(part(of));
    writer.add_name();
  }
  /// The items in postfix order, "#" behind operators.
  std::string items() {
    writer.end_expression();
    std::string all;
    for (const ExpressionItem& item : writer.take_items()) {
      if (!all.empty()) all += ' ';
      all += item.text;
      if (item.kind == ItemKind::binary || item.kind == ItemKind::prefix) all += '#';
      if (item.kind == ItemKind::call) all += "(" + std::to_string(item.n_arguments) + ")";
      if (item.kind == ItemKind::store) all += "=";
    }
    return all;
  }

  std::string text;
  ExpressionWriter writer;
};

template <class Work>
std::string refusal_of(const Work& work) {
  try {
    work();
  } catch (const ExpressionError& error) {
    return std::to_string(error.offset) + "+" + std::to_string(error.length) + ": " + error.text +
           (error.hint.empty() ? "" : "; " + error.hint);
  }
  return "";
}

}  // namespace

TEST_CASE("an operator waits for those behind it that bind more", "[parser][expression]") {
  Written sum("1+2*3-4");
  sum.number("1");
  sum.writer.add_binary(sum.token("+"));
  sum.number("2");
  sum.writer.add_binary(sum.token("*"));
  sum.number("3");
  sum.writer.add_binary(sum.token("-"));
  sum.number("4");
  CHECK(sum.items() == "1 2 3 *# +# 4 -#");
}

TEST_CASE("powers group to the right where that is not refused", "[parser][expression]") {
  const auto chain = [](bool is_strict) {
    Written power("2^3^4", 0, is_strict);
    power.number("2");
    power.writer.add_binary(power.token("^"));
    power.number("3");
    OperatorToken second = power.token("^");
    second.text = std::string_view(power.text).substr(3, 1);
    power.writer.add_binary(second);
    power.number("4");
    return power.items();
  };
  CHECK(chain(false) == "2 3 4 ^# ^#");
  CHECK(refusal_of([&] { chain(true); }) ==
        "3+1: a ^ b ^ c has two readings; say by parentheses what belongs together");
}

TEST_CASE("a sign before a power of a number has two readings, of a name it has one",
          "[parser][expression]") {
  const auto signed_power = [](const std::string& base) {
    Written power("-" + base + "^3", 10);
    power.writer.add_prefix(power.token("-", true));
    base == "2" ? power.number(base) : power.name(base);
    power.writer.add_binary(power.token("^"));
    power.number("3");
    return power.items();
  };
  CHECK(signed_power("x") == "x 3 ^# -#");
  CHECK(refusal_of([&] { signed_power("2"); }) ==
        "10+1: -2^... has two readings; say by parentheses what belongs together");
}

TEST_CASE("a group and a call close what is in them", "[parser][expression]") {
  Written product("(1+2)*f(3,4)");
  product.writer.open_group(product.part("("));
  CHECK(product.writer.innermost() == "(");
  product.number("1");
  product.writer.add_binary(product.token("+"));
  product.number("2");
  product.writer.end_expression();
  product.writer.close();
  CHECK(product.writer.innermost() == "");
  product.writer.add_binary(product.token("*"));
  product.writer.keep_name(product.part("f"));
  product.writer.open_call(product.part("("));
  product.number("3");
  product.writer.end_expression();
  product.writer.end_argument();
  product.number("4");
  product.writer.end_expression();
  product.writer.end_argument();
  product.writer.close();
  CHECK(product.items() == "1 2 +# 3 4 f(2) *#");
}

TEST_CASE("an assignment stores what is behind it, one with an operator looks the name up last",
          "[parser][expression]") {
  Written plain("a=1", 0, false);
  plain.writer.keep_name(plain.part("a"));
  const auto rows = expression_operators();
  const auto row = [&](std::string_view symbol) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const ExpressionOperator& one) {
      return one.symbol == symbol && one.level == ExpressionLevel::assignment;
    });
    return &*found;
  };
  plain.writer.add_assignment({plain.part("="), row("=")});
  plain.number("1");
  CHECK(plain.items() == "1 a=");
  Written sum("a+=1", 0, false);
  sum.writer.keep_name(sum.part("a"));
  sum.writer.add_assignment({sum.part("+="), row("+=")});
  sum.number("1");
  CHECK(sum.items() == "1 a += +=# a=");
}

TEST_CASE("numbers and strings are what stands there, numbers out of range are refused",
          "[parser][expression]") {
  Written values("1.5e3 \"a b\"");
  values.number("1.5e3");
  values.writer.add_string(values.part("\"a b\""));
  const std::vector<ExpressionItem> items = values.writer.take_items();
  REQUIRE(items.size() == 2);
  CHECK(items[0].number == 1500.0);
  CHECK(items[1].text == "a b");
  CHECK(items[1].offset == 6);
  Written large("1e999", 3);
  CHECK(refusal_of([&] { large.number("1e999"); }) == "3+5: the number 1e999 is out of range");
}

TEST_CASE("a step behind a name gives the value from before", "[parser][expression]") {
  Written step("a++", 0, false);
  step.writer.keep_name(step.part("a"));
  step.writer.keep_step(step.token("++"));
  step.writer.step_behind_name();
  const std::vector<ExpressionItem> items = step.writer.take_items();
  std::vector<ItemKind> kinds;
  for (const ExpressionItem& item : items) kinds.push_back(item.kind);
  CHECK(kinds == std::vector<ItemKind>{ItemKind::name, ItemKind::copy, ItemKind::number, ItemKind::binary,
                                       ItemKind::store, ItemKind::drop});
}

TEST_CASE("what is open is nested at most 200 deep", "[parser][expression]") {
  Written deep(std::string(201, '('));
  const auto open = [&](std::size_t i) { deep.writer.open_group(std::string_view(deep.text).substr(i, 1)); };
  for (std::size_t i = 0; i < 200; ++i) open(i);
  CHECK(refusal_of([&] { open(200); }) == "200+1: the expression is nested more than 200 deep");
}

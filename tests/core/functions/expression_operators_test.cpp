// SPDX-License-Identifier: BSD-3-Clause
#include "core/functions/expression_operators.hpp"

#include <array>
#include <string>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

const ExpressionOperator& find(std::string_view symbol, ExpressionLevel level, ExpressionDialects dialect) {
  for (const ExpressionOperator& row : expression_operators()) {
    if (row.symbol == symbol && row.level == level && has_dialect(row.dialects, dialect)) return row;
  }
  FAIL("no such operator");
  return expression_operators().front();
}

}  // namespace

TEST_CASE("a symbol has one meaning before a value and one behind it", "[core][expression]") {
  for (const auto dialect : {ExpressionDialects::function, ExpressionDialects::aprepro}) {
    for (const ExpressionOperator& row : expression_operators()) {
      if (!has_dialect(row.dialects, dialect)) continue;
      int n_alike = 0;
      for (const ExpressionOperator& other : expression_operators()) {
        const bool is_alike =
            has_dialect(other.dialects, dialect) && other.symbol == row.symbol &&
            (other.level == ExpressionLevel::prefix) == (row.level == ExpressionLevel::prefix);
        n_alike += is_alike ? 1 : 0;
      }
      INFO(row.symbol);
      CHECK(n_alike == 1);
    }
  }
}

TEST_CASE("the remainder of functions is that of reals, of Aprepro that of integers", "[core][expression]") {
  const std::array values{9.5, 4.5};
  CHECK(find("%", ExpressionLevel::product, ExpressionDialects::function).body(values) == 0.5);
  CHECK(find("%", ExpressionLevel::product, ExpressionDialects::aprepro).body(values) == 1.0);
}

TEST_CASE("an item fails at its name or its operator", "[core][expression]") {
  const ExpressionOperator& op = find("&&", ExpressionLevel::logical_and, ExpressionDialects::function);
  try {
    fail_at({.kind = ExpressionItem::Kind::binary, .offset = 7, .op = &op, .text = "&&"}, "wrong",
            "so it is");
  } catch (const ExpressionError& error) {
    CHECK(error.offset == 7);
    CHECK(error.length == 2);
    CHECK(error.text == "wrong");
    CHECK(error.hint == "so it is");
  }
}

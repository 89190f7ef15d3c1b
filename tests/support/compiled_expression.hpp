// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/functions/expression.hpp"
#include "parser/text/expression_grammar.hpp"

namespace contactsim::test {

inline Expression compiled(const std::string& text, const std::vector<std::string>& inputs) {
  return compile_expression(read_deck_expression({}, text), inputs);
}

/// The value of an expression of x.
inline double value_of(const std::string& text, double x = std::numeric_limits<double>::quiet_NaN()) {
  const std::vector<std::string> inputs{"x"};
  return compiled(text, inputs).evaluate({&x, 1});
}

/// "offset+length: text; hint" of what is wrong with the expression, "" when it compiles.
inline std::string problem_of(const std::string& text, const std::vector<std::string>& inputs = {"x"}) {
  try {
    compiled(text, inputs);
    return "";
  } catch (const ExpressionError& error) {
    return std::to_string(error.offset) + "+" + std::to_string(error.length) + ": " + error.text +
           (error.hint.empty() ? "" : "; " + error.hint);
  }
}

/// A text again and again.
inline std::string repeated(const std::string& text, int n) {
  std::string all;
  for (int i = 0; i < n; ++i) all += text;
  return all;
}

}  // namespace contactsim::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/deck_location.hpp"

namespace contactsim {

struct ExpressionOperator;

/// What is wrong in an expression, and where.
struct ExpressionError {
  std::size_t offset = 0;  ///< into the expression's text
  int length = 1;
  std::string text;
  std::string hint = {};
};

/// One item of an expression in postfix order: values are put on a stack, the others take theirs from it.
/// `a = 2*x` is 2, x, binary *, store a. Of `c ? p : q` the order is c, choose, p, otherwise, q, chosen.
struct ExpressionItem {
  enum class Kind : std::uint8_t {
    number,     ///< puts `number`
    string,     ///< puts the string `text`
    name,       ///< puts the value of the name `text`
    call,       ///< takes `n_arguments`, puts the value of the function `text`
    prefix,     ///< takes one value, puts that of the operator before it
    binary,     ///< takes two values, puts that of the operator between them
    store,      ///< sets the name `text` to the top, which stays
    drop,       ///< takes the top off
    copy,       ///< puts the top once more
    swap,       ///< exchanges the two on top
    choose,     ///< behind the condition of a ?:
    otherwise,  ///< behind its first value
    chosen      ///< behind its second value
  };
  Kind kind = Kind::number;
  std::size_t offset = 0;  ///< into the expression's text
  double number = 0.0;
  std::size_t n_arguments = 0;
  const ExpressionOperator* op = nullptr;  ///< row of expression_operators(), of prefix and binary
  std::string text = {};  ///< of a name, a string without its quotes, and the symbol of an operator
};

/// An expression of the deck, such as EVALUATE EXPRESSION = "<text>", taken apart when the deck is read.
struct DeckExpression {
  DeckLocation location;  ///< of the text, or of the quote before it
  std::string text;
  std::vector<ExpressionItem> items = {};     ///< empty when there is an error
  std::optional<ExpressionError> error = {};  ///< for whoever uses it: one that nothing uses does no harm
};

}  // namespace contactsim

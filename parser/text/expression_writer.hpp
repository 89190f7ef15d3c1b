// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/functions/expression_operators.hpp"

namespace contactsim {

/// An operator where it stands in an expression.
struct OperatorToken {
  std::string_view text;  ///< into the expression
  const ExpressionOperator* row = nullptr;
};

/// Puts the tokens of an expression, which the grammar hands over from left to right, into postfix order by
/// the levels of its operators: each waits on a stack until one that binds less, or the end, comes. Source:
/// Dijkstra, Algol 60 translation, Mathematisch Centrum MR 34/61 (the shunting yard).
class ExpressionWriter {
 public:
  ///   text       the whole expression, which must outlive the object; all tokens are parts of it
  ///   base       added to the offsets of items and errors
  ///   is_strict  what Sierra and C read differently is an error: -2^2, a^b^c, a && b || c, a < b < c
  ExpressionWriter(std::string_view text, std::size_t base, bool is_strict)
      : text_(text), base_(base), is_strict_(is_strict) {
    constexpr std::size_t usual_length = 8;
    items_.reserve(usual_length);
    waiting_.reserve(usual_length);
  }

  void add_number(std::string_view token);  ///< throws ExpressionError when it is out of range
  void add_string(std::string_view token);  ///< with its quotes
  void keep_name(std::string_view token) { name_ = token; }
  std::string_view kept_name() const { return name_; }
  void add_name() { write(Kind::name, name_); }  ///< the kept name as a value
  void add_prefix(const OperatorToken& op) { wait({op.text, op.row, {}, 0, false, true}); }
  void add_binary(const OperatorToken& op);
  void add_assignment(const OperatorToken& op) { wait({op.text, op.row, name_, 0, false, true}); }
  void end_statement(std::string_view token) { write(Kind::drop, token); }

  void keep_step(const OperatorToken& op) { step_ = op; }  ///< ++ or --, to which a name or number belongs
  void step_name(std::string_view token);
  void step_number(std::string_view token);
  void step_behind_name();  ///< the kept name

  void open_group(std::string_view token) { wait({token, nullptr, {}, 0, true, true}); }
  void open_call(std::string_view token) { wait({token, nullptr, name_, 0, true, true}); }
  void open_bracket(const OperatorToken& op) { wait({op.text, op.row, {}, 0, true, true}); }
  void open_choice(std::string_view token);                                     ///< ?
  void split_choice(std::string_view token) { write(Kind::otherwise, token); }  ///< :
  void end_argument() { ++waiting_.back().n_arguments; }
  void end_expression();  ///< writes what waits since the last opening
  void close();           ///< what was opened last

  /// What was opened last and not closed, such as "("; "" when there is nothing.
  std::string_view innermost() const;
  std::vector<ExpressionItem> take_items() { return std::move(items_); }

  /// Throws the ExpressionError of a token.
  [[noreturn]] void fail(std::string_view token, std::string text, std::string hint = "") const;

 private:
  using Kind = ExpressionItem::Kind;
  /// An operator that waits for its right side, or something open.
  struct Waiting {
    std::string_view token;
    const ExpressionOperator* row = nullptr;
    std::string_view name = {};  ///< of an assignment or a call
    std::size_t n_arguments = 0;
    bool is_open = false;
    bool is_nested = false;  ///< counts as one level of nesting
  };

  void wait(const Waiting& waiting);
  Waiting take_waiting();
  bool is_operator_waiting() const { return !waiting_.empty() && !waiting_.back().is_open; }
  void write_operator();
  void check_power(const OperatorToken& op) const;
  void write_step(const OperatorToken& op);
  ExpressionItem& write(Kind kind, std::string_view token, const ExpressionOperator* row = nullptr);

  std::string_view text_;
  std::size_t base_;
  bool is_strict_;
  std::vector<ExpressionItem> items_;
  std::vector<Waiting> waiting_;
  std::string_view name_;
  OperatorToken step_;
  std::string_view number_;  ///< when the last token was one
  int depth_ = 0;
};

}  // namespace contactsim

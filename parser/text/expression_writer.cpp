// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/expression_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

namespace contactsim {

namespace {

using Level = ExpressionLevel;

constexpr int max_depth = 200;
constexpr const char* needs_parentheses = "say by parentheses what belongs together";

bool is_at(Level level, const ExpressionOperator* row) { return row != nullptr && row->level == level; }

}  // namespace

void ExpressionWriter::fail(std::string_view token, std::string text, std::string hint) const {
  const auto length = std::max<std::size_t>(1, token.size());
  throw ExpressionError{static_cast<std::size_t>(token.data() - text_.data()) + base_,
                        static_cast<int>(length), std::move(text), std::move(hint)};
}

ExpressionItem& ExpressionWriter::write(Kind kind, std::string_view token, const ExpressionOperator* row) {
  ExpressionItem& item = items_.emplace_back();
  item.kind = kind;
  item.offset = static_cast<std::size_t>(token.data() - text_.data()) + base_;
  item.op = row;
  item.text = token;
  number_ = {};
  return item;
}

void ExpressionWriter::add_number(std::string_view token) {
  ExpressionItem& item = write(Kind::number, token);
  const auto result = std::from_chars(token.data(), token.data() + token.size(), item.number);
  if (result.ec != std::errc()) fail(token, fmt::format("the number {} is out of range", token));
  number_ = token;
}

void ExpressionWriter::add_string(std::string_view token) {
  write(Kind::string, token).text = token.substr(1, token.size() - 2);
}

void ExpressionWriter::add_binary(const OperatorToken& op) {
  if (is_strict_ && op.row->level == Level::power) check_power(op);
  const ExpressionOperator* left = nullptr;
  while (is_operator_waiting()) {
    const ExpressionOperator* row = waiting_.back().row;
    const bool goes_on =
        row->level < op.row->level || (row->level == op.row->level && row->level == Level::power);
    if (goes_on) break;
    left = row;
    write_operator();
  }
  if (is_strict_ && op.row->level == Level::relation && is_at(Level::relation, left)) {
    fail(op.text, "comparisons do not form chains", "write a < b && b < c");
  }
  // Sierra reads a && b || c as a && (b || c), C as (a && b) || c.
  if (is_strict_ && op.row->level == Level::logical_or && is_at(Level::logical_and, left)) {
    fail(op.text, "a && b || c has two readings", needs_parentheses);
  }
  const bool is_chain =
      op.row->level == Level::power && is_operator_waiting() && is_at(Level::power, waiting_.back().row);
  wait({op.text, op.row, {}, 0, false, is_chain});
}

void ExpressionWriter::check_power(const OperatorToken& op) const {
  // Sierra takes the sign of a number into the number, but -x^2 as -(x^2).
  if (is_operator_waiting() && is_at(Level::prefix, waiting_.back().row) && waiting_.back().token != "!" &&
      !number_.empty()) {
    fail(waiting_.back().token, fmt::format("{}{}^... has two readings", waiting_.back().token, number_),
         needs_parentheses);
  }
  const auto left = std::find_if(waiting_.rbegin(), waiting_.rend(),
                                 [](const Waiting& w) { return !is_at(Level::prefix, w.row); });
  if (left != waiting_.rend() && is_at(Level::power, left->row))
    fail(op.text, "a ^ b ^ c has two readings", needs_parentheses);
}

void ExpressionWriter::step_name(std::string_view token) {
  name_ = token;
  add_name();
  write_step(step_);
  write(Kind::store, name_);
}

void ExpressionWriter::step_number(std::string_view token) {
  add_number(token);
  write_step(step_);
}

/// The value is that from before.
void ExpressionWriter::step_behind_name() {
  add_name();
  write(Kind::copy, name_);
  write_step(step_);
  write(Kind::store, name_);
  write(Kind::drop, name_);
}

void ExpressionWriter::write_step(const OperatorToken& op) {
  write(Kind::number, op.text).number = 1.0;
  write(Kind::binary, op.text, op.row);
}

void ExpressionWriter::open_choice(std::string_view token) {
  while (is_operator_waiting() && waiting_.back().row->level > Level::assignment) write_operator();
  write(Kind::choose, token);
  open_group(token);
}

void ExpressionWriter::end_expression() {
  while (is_operator_waiting()) write_operator();
}

void ExpressionWriter::close() {
  const Waiting open = take_waiting();
  number_ = {};
  if (open.token == "?") {
    write(Kind::chosen, open.token);
  } else if (open.row != nullptr) {
    write(Kind::prefix, open.token, open.row);
  } else if (!open.name.empty()) {
    write(Kind::call, open.name).n_arguments = open.n_arguments;
  }
}

std::string_view ExpressionWriter::innermost() const {
  const auto open =
      std::find_if(waiting_.rbegin(), waiting_.rend(), [](const Waiting& w) { return w.is_open; });
  return open != waiting_.rend() ? open->token : std::string_view();
}

void ExpressionWriter::wait(const Waiting& waiting) {
  if (waiting.is_nested && ++depth_ > max_depth)
    fail(waiting.token, fmt::format("the expression is nested more than {} deep", max_depth));
  waiting_.push_back(waiting);
}

ExpressionWriter::Waiting ExpressionWriter::take_waiting() {
  const Waiting last = waiting_.back();
  waiting_.pop_back();
  if (last.is_nested) --depth_;
  return last;
}

void ExpressionWriter::write_operator() {
  const Waiting op = take_waiting();
  if (op.row->level > Level::assignment) {
    write(op.row->level == Level::prefix ? Kind::prefix : Kind::binary, op.token, op.row);
    return;
  }
  // name += value: what the name holds is looked up after the value has been found.
  if (op.row->body != nullptr) {
    write(Kind::name, op.name);
    write(Kind::swap, op.token);
    write(Kind::binary, op.token, op.row);
  }
  write(Kind::store, op.name);
}

}  // namespace contactsim

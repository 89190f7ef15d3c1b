// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/names.hpp"
#include "core/functions/expression.hpp"
#include "core/functions/expression_operators.hpp"
#include "core/functions/expression_tokens.hpp"

namespace contactsim {

namespace {

using Kind = ExpressionStep::Kind;
using Token = ExpressionToken;
using TokenKind = ExpressionTokenKind;
using Arguments = std::span<const double>;

constexpr int max_depth = 200;
constexpr std::size_t max_locals = 100;
constexpr const char* needs_parentheses = "say by parentheses what belongs together";

std::string shown(const Token& token) {
  return token.kind == TokenKind::end ? "the end of the expression" : fmt::format("'{}'", token.text);
}

[[noreturn]] void fail_at(const Token& at, std::string text, std::string hint = "") {
  throw ExpressionError{at.offset, std::max(1, static_cast<int>(at.text.size())), std::move(text),
                        std::move(hint)};
}

}  // namespace

/// Writes the postfix program of an expression while reading it by precedence climbing.
class ExpressionCompiler {
 public:
  ExpressionCompiler(std::string_view text, std::span<const std::string> inputs)
      : tokens_(read_expression_tokens(text)), inputs_(inputs) {}
  Expression compile();

 private:
  void read_statement();
  void read_value();
  void read(ExpressionLevel lowest);
  void read_operator(const ExpressionOperator& op, bool& has_and);
  void read_prefix(ExpressionLevel lowest);
  void read_primary();
  void read_call(const Token& name);
  void read_name(const Token& name);

  void enter();
  std::size_t emit(Kind kind, std::size_t index = 0);
  void emit_number(double number);
  void emit_call(ExpressionFunction::Body body, std::size_t n_arguments);
  void push();
  void jump_to_here(std::size_t from) {
    expression_.steps_[from].index = static_cast<std::uint32_t>(expression_.steps_.size());
  }

  const Token& peek(std::size_t further = 0) const {
    return tokens_[std::min(next_ + further, tokens_.size() - 1)];
  }
  const Token& take() { return tokens_[peek().kind == TokenKind::end ? next_ : next_++]; }
  bool accept(std::string_view symbol);
  void expect(std::string_view symbol, const Token& opened_at);

  std::vector<Token> tokens_;
  std::span<const std::string> inputs_;
  std::vector<std::string> locals_;
  Expression expression_;
  std::size_t next_ = 0;
  std::size_t n_values_ = 0;
  int depth_ = 0;
};

bool ExpressionCompiler::accept(std::string_view symbol) {
  if (peek().kind != TokenKind::symbol || peek().text != symbol) return false;
  ++next_;
  return true;
}

void ExpressionCompiler::expect(std::string_view symbol, const Token& opened_at) {
  if (accept(symbol)) return;
  fail_at(peek(),
          fmt::format("expected '{}' for this '{}', found {}", symbol, opened_at.text, shown(peek())));
}

std::size_t ExpressionCompiler::emit(Kind kind, std::size_t index) {
  expression_.steps_.push_back({kind, static_cast<std::uint32_t>(index), 0.0, nullptr});
  return expression_.steps_.size() - 1;
}

void ExpressionCompiler::emit_number(double number) {
  push();
  expression_.steps_[emit(Kind::number)].number = number;
}

void ExpressionCompiler::emit_call(ExpressionFunction::Body body, std::size_t n_arguments) {
  expression_.steps_[emit(Kind::call, n_arguments)].body = body;
  n_values_ -= n_arguments - 1;
}

void ExpressionCompiler::push() {
  ++n_values_;
  if (n_values_ + max_locals > max_expression_values) {
    fail_at(peek(), "the expression keeps too many values at a time",
            "give its parts names: a = ...; b = ...;");
  }
}

void ExpressionCompiler::enter() {
  if (++depth_ > max_depth)
    fail_at(peek(), fmt::format("the expression is nested more than {} deep", max_depth));
}

Expression ExpressionCompiler::compile() {
  while (accept(";")) continue;
  if (peek().kind == TokenKind::end) fail_at(peek(), "the expression is empty");
  read_statement();
  while (peek().kind != TokenKind::end) {
    if (!accept(";")) {
      fail_at(peek(),
              fmt::format("expected an operator or the end of the expression, found {}", shown(peek())));
    }
    while (accept(";")) continue;
    if (peek().kind == TokenKind::end) break;
    emit(Kind::drop);
    --n_values_;
    read_statement();
  }
  expression_.n_locals_ = locals_.size();
  return std::move(expression_);
}

void ExpressionCompiler::read_statement() {
  if (peek().kind != TokenKind::name || peek(1).text != "=") return read_value();
  const Token name = take();
  ++next_;
  read_value();
  const std::string folded = fold(name.text);
  const auto found = std::find(locals_.begin(), locals_.end(), folded);
  emit(Kind::store, static_cast<std::size_t>(found - locals_.begin()));
  if (found != locals_.end()) return;
  if (locals_.size() == max_locals) fail_at(name, fmt::format("more than {} names are assigned", max_locals));
  locals_.push_back(folded);
}

/// An expression with its ?:, which binds least and groups to the right.
void ExpressionCompiler::read_value() {
  enter();
  read(ExpressionLevel::lowest);
  const Token question = peek();
  if (accept("?")) {
    const std::size_t skip_true = emit(Kind::jump_if_false);
    --n_values_;
    read_value();
    expect(":", question);
    const std::size_t skip_false = emit(Kind::jump);
    --n_values_;
    jump_to_here(skip_true);
    read_value();
    jump_to_here(skip_false);
  }
  --depth_;
}

void ExpressionCompiler::read(ExpressionLevel lowest) {
  read_prefix(lowest);
  bool has_and = false;
  const ExpressionOperator* before = nullptr;
  while (const ExpressionOperator* op =
             peek().kind == TokenKind::symbol ? find_expression_operator(peek().text) : nullptr) {
    if (op->level < lowest) break;
    const bool is_chain = before != nullptr && before->level == op->level;
    if (is_chain && op->level == ExpressionLevel::relation) {
      fail_at(peek(), "comparisons do not form chains", "write a < b && b < c");
    }
    if (is_chain && op->level == ExpressionLevel::power)
      fail_at(peek(), "a ^ b ^ c has two readings", needs_parentheses);
    read_operator(*op, has_and);
    before = op;
  }
}

void ExpressionCompiler::read_operator(const ExpressionOperator& op, bool& has_and) {
  // Sierra reads a && b || c as a && (b || c), C as (a && b) || c.
  if (op.level == ExpressionLevel::logical_and) has_and = true;
  if (op.level == ExpressionLevel::logical_or && has_and) {
    fail_at(peek(), "a && b || c has two readings", needs_parentheses);
  }
  ++next_;
  read(static_cast<ExpressionLevel>(static_cast<int>(op.level) + 1));
  emit_call(op.body, 2);
}

void ExpressionCompiler::read_prefix(ExpressionLevel lowest) {
  const Token sign = peek();
  if (!accept("-") && !accept("+") && !accept("!")) return read_primary();
  // Sierra takes the sign of a number into the number, but -x^2 as -(x^2).
  if (sign.text != "!" && peek().kind == TokenKind::number && peek(1).text == "^") {
    fail_at(sign, fmt::format("{}{}^... has two readings", sign.text, peek().text), needs_parentheses);
  }
  enter();
  read(std::max(lowest, ExpressionLevel::power));
  --depth_;
  if (sign.text == "-") emit_call([](Arguments a) { return -a[0]; }, 1);
  if (sign.text == "!") emit_call([](Arguments a) { return a[0] == 0.0 ? 1.0 : 0.0; }, 1);
}

void ExpressionCompiler::read_primary() {
  const Token at = take();
  if (at.kind == TokenKind::number) return emit_number(at.number);
  if (at.kind == TokenKind::name) return peek().text == "(" ? read_call(at) : read_name(at);
  if (at.text != "(") fail_at(at, fmt::format("expected a value, found {}", shown(at)));
  read_value();
  expect(")", at);
}

void ExpressionCompiler::read_call(const Token& name) {
  const ExpressionFunction* function = find_expression_function(fold(name.text));
  if (function == nullptr) {
    std::vector<std::string> known;
    for (const ExpressionFunction& row : expression_functions()) known.emplace_back(row.name);
    fail_at(name, fmt::format("unknown function '{}'", name.text), suggest(name.text, known));
  }
  if (function->body == nullptr) {
    fail_at(name, fmt::format("the function '{}' is not supported", name.text), std::string(function->help));
  }
  const Token opened_at = take();
  std::size_t n_arguments = 0;
  if (!accept(")")) {
    do {
      read_value();
      ++n_arguments;
    } while (accept(","));
    expect(")", opened_at);
  }
  if (n_arguments < function->min_arguments || n_arguments > function->max_arguments) {
    const std::size_t n_expected =
        n_arguments < function->min_arguments ? function->min_arguments : function->max_arguments;
    fail_at(name, fmt::format("'{}({})' takes {} argument{}, found {}", function->name, function->parameters,
                              n_expected, n_expected == 1 ? "" : "s", n_arguments));
  }
  emit_call(function->body, n_arguments);
}

void ExpressionCompiler::read_name(const Token& name) {
  const std::string folded = fold(name.text);
  const auto position_in = [&](std::span<const std::string> names) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), folded) - names.begin());
  };
  const std::size_t local = position_in(locals_), input = position_in(inputs_);
  if (local < locals_.size() || input < inputs_.size()) {
    push();
    emit(local < locals_.size() ? Kind::local : Kind::input, local < locals_.size() ? local : input);
    return;
  }
  if (const auto constant = find_expression_constant(folded)) return emit_number(*constant);
  std::vector<std::string> known(inputs_.begin(), inputs_.end());
  known.insert(known.end(), locals_.begin(), locals_.end());
  std::string hint = name.text.size() > 2 ? suggest(name.text, known) : "";
  if (hint.empty()) hint = fmt::format("it may read {}", fmt::join(known, " "));
  fail_at(name, fmt::format("unknown name '{}' in the expression", name.text), std::move(hint));
}

Expression compile_expression(std::string_view text, std::span<const std::string> inputs) {
  return ExpressionCompiler(text, inputs).compile();
}

}  // namespace contactsim

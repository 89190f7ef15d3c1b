// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "core/base/names.hpp"
#include "parser/aprepro/calls.hpp"
#include "parser/aprepro/control.hpp"
#include "parser/aprepro/operators.hpp"
#include "parser/aprepro/tokens.hpp"

namespace contactsim {

namespace {

using Kind = ApreproTokenKind;
using Token = ApreproToken;

constexpr int max_depth = 200;

std::string shown(const Token& token) {
  return token.kind == Kind::end ? "the end of the expression" : fmt::format("'{}'", token.text);
}

/// One expression, evaluated while it is read, by precedence climbing.
class Evaluator {
 public:
  Evaluator(std::vector<Token> tokens, ApreproState& state) : tokens_(std::move(tokens)), state_(state) {}
  ApreproValue evaluate();

 private:
  ApreproValue read(ApreproLevel lowest);
  ApreproValue read_prefix();
  ApreproValue read_primary();
  ApreproValue read_named(const Token& name);
  ApreproValue read_call(const Token& name);
  ApreproValue read_ternary(const ApreproValue& condition);
  ApreproValue read_assignment(const Token& name);
  ApreproValue read_step(const Token& name, const Token& step, bool gives_new_value);
  ApreproValue value_of(const Token& name);
  ApreproValue assign(const Token& name, ApreproValue value);

  void charge(std::size_t work, const Token& at);

  const Token& peek() const { return tokens_[next_]; }
  const Token& take() { return tokens_[peek().kind == Kind::end ? next_ : next_++]; }
  bool is_next(std::string_view symbol) const { return peek().kind == Kind::symbol && peek().text == symbol; }
  bool accept(std::string_view symbol);
  void expect(std::string_view symbol, const Token& opened_at);

  std::vector<Token> tokens_;
  ApreproState& state_;
  std::size_t next_ = 0;
  int depth_ = 0;
};

void Evaluator::charge(std::size_t work, const Token& at) {
  state_.work += work;
  if (state_.work > state_.max_work) fail_at(at, "the deck expands without end, or to too much");
}

bool Evaluator::accept(std::string_view symbol) {
  if (!is_next(symbol)) return false;
  ++next_;
  return true;
}

void Evaluator::expect(std::string_view symbol, const Token& opened_at) {
  if (accept(symbol)) return;
  fail_at(peek(),
          fmt::format("expected '{}' for this '{}', found {}", symbol, opened_at.text, shown(peek())));
}

ApreproValue Evaluator::evaluate() {
  ApreproValue value = read(ApreproLevel::lowest);
  if (peek().kind == Kind::end) return value;
  fail_at(peek(), fmt::format("expected an operator or '}}', found {}", shown(peek())),
          "one expression per pair of braces");
}

ApreproValue Evaluator::read(ApreproLevel lowest) {
  if (++depth_ > max_depth)
    fail_at(peek(), fmt::format("the expression is nested more than {} deep", max_depth));
  ApreproValue left = read_prefix();
  while (peek().kind == Kind::symbol) {
    const Token& at = peek();
    const auto level = find_aprepro_level(at.text);
    if (!level || *level < lowest) break;
    ++next_;
    if (*level == ApreproLevel::ternary) {
      left = read_ternary(left);
    } else {
      const auto above = static_cast<ApreproLevel>(static_cast<int>(*level) + 1);
      const ApreproValue right = read(*level == ApreproLevel::power ? *level : above);
      left = combine(left, at, right);
      if (const std::string* text = std::get_if<std::string>(&left)) charge(text->size(), at);
    }
  }
  --depth_;
  return left;
}

ApreproValue Evaluator::read_ternary(const ApreproValue& condition) {
  const Token& question = tokens_[next_ - 1];
  ApreproValue if_true = read(ApreproLevel::lowest);
  if (!is_next(":")) {
    fail_at(peek(), fmt::format("expected ':' for this '?', found {}", shown(peek())),
            "a name may hold ':', so put a blank before it");
  }
  ++next_;
  ApreproValue if_false = read(ApreproLevel::ternary);
  if (if_true.index() != if_false.index()) fail_at(question, "'?' chooses between a number and a string");
  return is_true(condition) ? if_true : if_false;
}

ApreproValue Evaluator::read_prefix() {
  const Token at = peek();
  if (at.kind != Kind::symbol) return read_primary();
  if (accept("-")) return -number_of(read(ApreproLevel::power), at);
  if (accept("+")) return number_of(read(ApreproLevel::power), at);
  if (accept("!")) return is_true(read(ApreproLevel::power)) ? 0.0 : 1.0;
  if (!is_next("++") && !is_next("--")) return read_primary();
  ++next_;
  const Token target = take();
  if (target.kind == Kind::name) return read_step(target, at, true);
  if (target.kind == Kind::number) return target.number + (at.text == "++" ? 1.0 : -1.0);
  fail_at(at, fmt::format("'{}' takes a name, found {}", at.text, shown(target)));
}

ApreproValue Evaluator::read_primary() {
  const Token at = take();
  if (at.kind == Kind::number) return at.number;
  if (at.kind == Kind::string) return std::string(at.text);
  if (at.kind == Kind::name) return read_named(at);
  if (at.text == "(") {
    ApreproValue value = read(ApreproLevel::lowest);
    expect(")", at);
    return value;
  }
  if (at.text == "[") {
    const double value = number_of(read(ApreproLevel::lowest), at);
    expect("]", at);
    return std::trunc(value);
  }
  fail_at(at, fmt::format("expected a value, found {}", shown(at)));
}

ApreproValue Evaluator::read_named(const Token& name) {
  if (is_next("(")) return read_call(name);
  if (is_next("[")) fail_at(name, "arrays are not supported");
  if (is_next("++") || is_next("--")) return read_step(name, take(), false);
  constexpr std::array<std::string_view, 7> assignments = {"=", "+=", "-=", "*=", "/=", "^=", "**="};
  for (const std::string_view symbol : assignments) {
    if (is_next(symbol)) return read_assignment(name);
  }
  return value_of(name);
}

ApreproValue Evaluator::read_call(const Token& name) {
  const ApreproFunction* function = find_aprepro_function(name.text);
  if (function == nullptr) {
    std::vector<std::string> known = aprepro_control_words();
    for (const ApreproFunction& row : aprepro_functions()) known.emplace_back(row.name);
    fail_at(name, fmt::format("unknown function '{}'", name.text), suggest(name.text, known));
  }
  const Token& opened_at = take();
  std::vector<ApreproValue> arguments;
  if (!is_next(")")) {
    do {
      arguments.push_back(read(ApreproLevel::lowest));
    } while (accept(",") || accept(";"));
  }
  expect(")", opened_at);
  return call_aprepro_function(*function, name, arguments, state_);
}

ApreproValue Evaluator::read_assignment(const Token& name) {
  const Token at = take();
  ApreproValue value = read(ApreproLevel::lowest);
  if (at.text == "=") return assign(name, std::move(value));
  return assign(name, combine(value_of(name), at, value));
}

ApreproValue Evaluator::read_step(const Token& name, const Token& step, bool gives_new_value) {
  const double old_value = number_of(value_of(name), step);
  const ApreproValue value = assign(name, step.text == "++" ? old_value + 1.0 : old_value - 1.0);
  return gives_new_value ? value : ApreproValue(old_value);
}

ApreproValue Evaluator::value_of(const Token& name) {
  if (const ApreproValue* value = state_.variables.find(name.text)) {
    if (const std::string* text = std::get_if<std::string>(value)) charge(text->size(), name);
    return *value;
  }
  const bool has_likeness = name.text.size() > 2;
  std::vector<std::string> known = state_.variables.names();
  for (const std::string& word : aprepro_control_words()) known.push_back(word);
  constexpr std::size_t cost_of_comparing = 100;
  charge(cost_of_comparing * known.size(), name);
  state_.warn("aprepro-undefined", {name.offset, static_cast<int>(name.text.size()),
                                    fmt::format("'{}' is not defined, 0 is taken", name.text),
                                    has_likeness ? suggest(name.text, known) : ""});
  return 0.0;
}

ApreproValue Evaluator::assign(const Token& name, ApreproValue value) {
  using Assigned = ApreproVariables::Assigned;
  const auto assigned = state_.variables.assign(name.text, value, state_.makes_immutable);
  if (assigned == Assigned::done) return value;
  const ApreproValue kept = *state_.variables.find(name.text);
  const std::string shown_value = std::holds_alternative<double>(kept)
                                      ? state_.variables.print(std::get<double>(kept))
                                      : std::get<std::string>(kept);
  const bool is_override = assigned == Assigned::overridden;
  state_.warn(is_override ? "aprepro-override" : "aprepro-immutable",
              {name.offset, static_cast<int>(name.text.size()),
               fmt::format("'{}' stays {}, as it is {}", name.text, shown_value,
                           is_override ? "given on the command line" : "immutable")});
  return kept;
}

}  // namespace

ApreproValue evaluate_aprepro(std::string_view expression, std::size_t base, ApreproState& state) {
  state.work += expression.size();
  return Evaluator(read_aprepro_tokens(expression, base), state).evaluate();
}

}  // namespace contactsim

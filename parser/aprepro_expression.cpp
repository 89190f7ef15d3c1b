// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "core/names.hpp"
#include "parser/aprepro_control.hpp"
#include "parser/aprepro_tokens.hpp"

namespace contactsim {

namespace {

using Kind = ApreproTokenKind;
using Token = ApreproToken;

constexpr int max_depth = 200;

/// How strongly operators bind; higher binds more.
enum Level {
  ternary = 5,
  logical_or = 6,
  logical_and = 7,
  relation = 8,
  sum = 9,
  product = 10,
  sign = 11,
  power = 12,
  concatenation = 14
};

struct Operator {
  std::string_view symbol;
  Level level;
};

constexpr Operator operators[] = {
    {"?", ternary},  {"||", logical_or}, {"&&", logical_and},   {"==", relation}, {"!=", relation},
    {"<", relation}, {">", relation},    {"<=", relation},      {">=", relation}, {"+", sum},
    {"-", sum},      {"*", product},     {"/", product},        {"%", product},   {"~", product},
    {"^", power},    {"**", power},      {"//", concatenation},
};

const Operator* find_operator(std::string_view symbol) {
  const auto found = std::find_if(std::begin(operators), std::end(operators),
                                  [&](const Operator& o) { return o.symbol == symbol; });
  return found == std::end(operators) ? nullptr : found;
}

[[noreturn]] void fail(const Token& at, std::string text, std::string hint = "") {
  const int length = at.kind == Kind::end ? 1 : static_cast<int>(at.text.size());
  throw ApreproError{at.offset, length, std::move(text), std::move(hint)};
}

std::string shown(const Token& token) {
  return token.kind == Kind::end ? "the end of the expression" : fmt::format("'{}'", token.text);
}

double truth(bool value) { return value ? 1.0 : 0.0; }

double number_of(const ApreproValue& value, const Token& at) {
  if (const double* number = std::get_if<double>(&value)) return *number;
  fail(at, fmt::format("'{}' takes numbers, found a string", at.text),
       at.text == "+" ? "'//' joins strings" : "");
}

double checked(double value, const Token& at) {
  if (std::isfinite(value)) return value;
  fail(at, fmt::format("'{}' has no finite value here", at.text));
}

double divisor_of(const ApreproValue& value, const Token& at) {
  const double divisor = number_of(value, at);
  if (divisor == 0.0) fail(at, "division by zero");
  return divisor;
}

template <class T>
double compare(const T& a, const T& b, std::string_view symbol) {
  if (symbol == "==") return truth(a == b);
  if (symbol == "!=") return truth(a != b);
  if (symbol == "<") return truth(a < b);
  if (symbol == ">") return truth(a > b);
  return truth(symbol == "<=" ? a <= b : a >= b);
}

double compare_values(const ApreproValue& a, const ApreproValue& b, const Token& at) {
  if (a.index() != b.index()) fail(at, fmt::format("'{}' compares a number with a string", at.text));
  if (const double* number = std::get_if<double>(&a)) return compare(*number, std::get<double>(b), at.text);
  return compare(std::get<std::string>(a), std::get<std::string>(b), at.text);
}

double calculate(double a, double b, const Token& at) {
  if (at.text == "+" || at.text == "+=") return checked(a + b, at);
  if (at.text == "-" || at.text == "-=") return checked(a - b, at);
  if (at.text == "*" || at.text == "*=" || at.text == "~") return checked(a * b, at);
  if (at.text == "%") return std::fmod(std::trunc(a), divisor_of(std::trunc(b), at));
  if (at.text == "/" || at.text == "/=") return checked(a / divisor_of(b, at), at);
  return checked(std::pow(a, b), at);
}

/// One expression, evaluated while it is read, by precedence climbing.
class Evaluator {
 public:
  Evaluator(std::vector<Token> tokens, ApreproState& state) : tokens_(std::move(tokens)), state_(state) {}
  ApreproValue evaluate();

 private:
  ApreproValue read(int lowest_level);
  ApreproValue read_prefix();
  ApreproValue read_primary();
  ApreproValue read_named(const Token& name);
  ApreproValue read_call(const Token& name);
  ApreproValue read_ternary(const ApreproValue& condition);
  ApreproValue read_assignment(const Token& name);
  ApreproValue read_step(const Token& name, const Token& step, bool gives_new_value);
  ApreproValue apply(const Token& at, const ApreproValue& a, const ApreproValue& b);
  ApreproValue concatenate(const Token& at, const ApreproValue& a, const ApreproValue& b);
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
  if (state_.work > max_aprepro_work) fail(at, "the deck expands without end, or to too much");
}

bool Evaluator::accept(std::string_view symbol) {
  if (!is_next(symbol)) return false;
  ++next_;
  return true;
}

void Evaluator::expect(std::string_view symbol, const Token& opened_at) {
  if (accept(symbol)) return;
  fail(peek(), fmt::format("expected '{}' for this '{}', found {}", symbol, opened_at.text, shown(peek())));
}

ApreproValue Evaluator::evaluate() {
  ApreproValue value = read(0);
  if (peek().kind == Kind::end) return value;
  fail(peek(), fmt::format("expected an operator or '}}', found {}", shown(peek())),
       "one expression per pair of braces");
}

ApreproValue Evaluator::read(int lowest_level) {
  if (++depth_ > max_depth)
    fail(peek(), fmt::format("the expression is nested more than {} deep", max_depth));
  ApreproValue left = read_prefix();
  while (peek().kind == Kind::symbol) {
    const Token& at = peek();
    const Operator* found = find_operator(at.text);
    if (found == nullptr || found->level < lowest_level) break;
    ++next_;
    if (found->level == ternary) {
      left = read_ternary(left);
    } else {
      const ApreproValue right = read(found->level == power ? power : found->level + 1);
      left = apply(at, left, right);
    }
  }
  --depth_;
  return left;
}

ApreproValue Evaluator::read_ternary(const ApreproValue& condition) {
  const Token& question = tokens_[next_ - 1];
  ApreproValue if_true = read(0);
  if (!is_next(":")) {
    fail(peek(), fmt::format("expected ':' for this '?', found {}", shown(peek())),
         "a name may hold ':', so put a blank before it");
  }
  ++next_;
  ApreproValue if_false = read(ternary);
  if (if_true.index() != if_false.index()) fail(question, "'?' chooses between a number and a string");
  return is_true(condition) ? if_true : if_false;
}

ApreproValue Evaluator::read_prefix() {
  const Token at = peek();
  if (at.kind != Kind::symbol) return read_primary();
  if (accept("-")) return -number_of(read(power), at);
  if (accept("+")) return number_of(read(power), at);
  if (accept("!")) return truth(!is_true(read(power)));
  if (!is_next("++") && !is_next("--")) return read_primary();
  ++next_;
  const Token target = take();
  if (target.kind == Kind::name) return read_step(target, at, true);
  if (target.kind == Kind::number)
    return calculate(target.number, 1.0, {Kind::symbol, at.text.substr(1), 0.0, at.offset});
  fail(at, fmt::format("'{}' takes a name, found {}", at.text, shown(target)));
}

ApreproValue Evaluator::read_primary() {
  const Token at = take();
  if (at.kind == Kind::number) return at.number;
  if (at.kind == Kind::string) return std::string(at.text);
  if (at.kind == Kind::name) return read_named(at);
  if (at.text == "(") {
    ApreproValue value = read(0);
    expect(")", at);
    return value;
  }
  if (at.text == "[") {
    const double value = number_of(read(0), at);
    expect("]", at);
    return std::trunc(value);
  }
  fail(at, fmt::format("expected a value, found {}", shown(at)));
}

ApreproValue Evaluator::read_named(const Token& name) {
  if (is_next("(")) return read_call(name);
  if (is_next("[")) fail(name, "arrays are not supported");
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
    fail(name, fmt::format("unknown function '{}'", name.text), suggest(name.text, known));
  }
  const Token& opened_at = take();
  std::vector<ApreproValue> arguments;
  if (!is_next(")")) {
    do {
      arguments.push_back(read(0));
    } while (accept(",") || accept(";"));
  }
  expect(")", opened_at);
  return call_aprepro_function(*function, name, arguments, state_);
}

ApreproValue Evaluator::read_assignment(const Token& name) {
  const Token at = take();
  ApreproValue value = read(0);
  if (at.text == "=") return assign(name, std::move(value));
  const double old_value = number_of(value_of(name), at);
  return assign(name, calculate(old_value, number_of(value, at), at));
}

ApreproValue Evaluator::read_step(const Token& name, const Token& step, bool gives_new_value) {
  const double old_value = number_of(value_of(name), step);
  const ApreproValue value = assign(name, step.text == "++" ? old_value + 1.0 : old_value - 1.0);
  return gives_new_value ? value : ApreproValue(old_value);
}

ApreproValue Evaluator::apply(const Token& at, const ApreproValue& a, const ApreproValue& b) {
  if (at.text == "//") return concatenate(at, a, b);
  if (at.text == "&&") return truth(is_true(a) && is_true(b));
  if (at.text == "||") return truth(is_true(a) || is_true(b));
  if (find_operator(at.text)->level == relation) return compare_values(a, b, at);
  return calculate(number_of(a, at), number_of(b, at), at);
}

ApreproValue Evaluator::concatenate(const Token& at, const ApreproValue& a, const ApreproValue& b) {
  const std::string* left = std::get_if<std::string>(&a);
  const std::string* right = std::get_if<std::string>(&b);
  if (!left || !right) fail(at, "'//' joins strings, found a number", "make a number text by tostring()");
  if (left->size() + right->size() > max_aprepro_string) fail(at, "the string grows past 1 MiB");
  charge(left->size() + right->size(), at);
  return *left + *right;
}

ApreproValue Evaluator::value_of(const Token& name) {
  if (const ApreproValue* value = state_.variables.find(name.text)) {
    if (const std::string* text = std::get_if<std::string>(value)) charge(text->size(), name);
    return *value;
  }
  std::vector<std::string> known = state_.variables.names();
  for (const std::string& word : aprepro_control_words()) known.push_back(word);
  constexpr std::size_t cost_of_comparing = 100;
  charge(cost_of_comparing * known.size(), name);
  state_.warn("aprepro-undefined",
              {name.offset, static_cast<int>(name.text.size()),
               fmt::format("'{}' is not defined, 0 is taken", name.text), suggest(name.text, known)});
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

bool is_true(const ApreproValue& value) {
  const double* number = std::get_if<double>(&value);
  return number != nullptr ? *number != 0.0 : !std::get<std::string>(value).empty();
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/names.hpp"
#include "core/functions/expression.hpp"
#include "core/functions/expression_operators.hpp"

namespace contactsim {

namespace {

using Kind = ExpressionStep::Kind;

constexpr std::size_t max_locals = 100;

}  // namespace

/// Writes the program of an expression item by item: names and functions are looked up, ?: become jumps.
class ExpressionCompiler {
 public:
  explicit ExpressionCompiler(std::span<const std::string> inputs) : inputs_(inputs) {}
  Expression compile(std::span<const ExpressionItem> items);

 private:
  void add(const ExpressionItem& item);
  void add_name(const ExpressionItem& name);
  void add_call(const ExpressionItem& call);
  void add_store(const ExpressionItem& name);

  void emit(const ExpressionItem& item, Kind kind, std::size_t index = 0, double number = 0.0);
  void emit_call(const ExpressionItem& item, ExpressionFunction::Body body, std::size_t n_arguments);
  void begin_jump(const ExpressionItem& item, Kind kind);
  void end_jump(std::size_t from) {
    expression_.steps_[from].index = static_cast<std::uint32_t>(expression_.steps_.size());
  }

  std::span<const std::string> inputs_;
  std::vector<std::string> locals_;
  std::vector<std::size_t> jumps_;  ///< whose end is not known yet, the innermost last
  Expression expression_;
  std::size_t n_values_ = 0;
};

void ExpressionCompiler::emit(const ExpressionItem& item, Kind kind, std::size_t index, double number) {
  const bool adds_value = kind == Kind::number || kind == Kind::input || kind == Kind::local;
  if (adds_value && ++n_values_ + max_locals > max_expression_values) {
    fail_at(item, "the expression keeps too many values at a time",
            "give its parts names: a = ...; b = ...;");
  }
  expression_.steps_.push_back({kind, static_cast<std::uint32_t>(index), number, nullptr});
}

void ExpressionCompiler::emit_call(const ExpressionItem& item, ExpressionFunction::Body body,
                                   std::size_t n_arguments) {
  if (body == nullptr) return;  // the sign +
  emit(item, Kind::call, n_arguments);
  expression_.steps_.back().body = body;
  n_values_ -= n_arguments - 1;
}

/// Jumps over one side of a ?:, of which only one leaves its value.
void ExpressionCompiler::begin_jump(const ExpressionItem& item, Kind kind) {
  jumps_.push_back(expression_.steps_.size());
  emit(item, kind);
  --n_values_;
}

Expression ExpressionCompiler::compile(std::span<const ExpressionItem> items) {
  for (const ExpressionItem& item : items) add(item);
  expression_.n_locals_ = locals_.size();
  return std::move(expression_);
}

void ExpressionCompiler::add(const ExpressionItem& item) {
  using ItemKind = ExpressionItem::Kind;
  switch (item.kind) {
    case ItemKind::number:
      return emit(item, Kind::number, 0, item.number);
    case ItemKind::name:
      return add_name(item);
    case ItemKind::call:
      return add_call(item);
    case ItemKind::prefix:
      return emit_call(item, item.op->body, 1);
    case ItemKind::binary:
      return emit_call(item, item.op->body, 2);
    case ItemKind::store:
      return add_store(item);
    case ItemKind::drop:
      emit(item, Kind::drop);
      --n_values_;
      break;
    case ItemKind::choose:
      return begin_jump(item, Kind::jump_if_false);
    case ItemKind::otherwise:
      begin_jump(item, Kind::jump);
      end_jump(jumps_[jumps_.size() - 2]);
      jumps_.erase(jumps_.end() - 2);
      break;
    case ItemKind::chosen:
      end_jump(jumps_.back());
      jumps_.pop_back();
      break;
    case ItemKind::string:
    case ItemKind::copy:
    case ItemKind::swap:
      break;  // Aprepro's alone
  }
}

void ExpressionCompiler::add_store(const ExpressionItem& name) {
  const std::string folded = fold(name.text);
  const auto found = std::find(locals_.begin(), locals_.end(), folded);
  emit(name, Kind::store, static_cast<std::size_t>(found - locals_.begin()));
  if (found != locals_.end()) return;
  if (locals_.size() == max_locals) fail_at(name, fmt::format("more than {} names are assigned", max_locals));
  locals_.push_back(folded);
}

void ExpressionCompiler::add_call(const ExpressionItem& call) {
  const ExpressionFunction* function = find_expression_function(fold(call.text));
  if (function == nullptr) {
    std::vector<std::string> known;
    for (const ExpressionFunction& row : expression_functions()) known.emplace_back(row.name);
    fail_at(call, fmt::format("unknown function '{}'", call.text), suggest(call.text, known));
  }
  if (function->body == nullptr) {
    fail_at(call, fmt::format("the function '{}' is not supported", call.text), std::string(function->help));
  }
  const std::size_t n_expected =
      std::clamp(call.n_arguments, function->min_arguments, function->max_arguments);
  if (call.n_arguments != n_expected) {
    fail_at(call, fmt::format("'{}({})' takes {} argument{}, found {}", function->name, function->parameters,
                              n_expected, n_expected == 1 ? "" : "s", call.n_arguments));
  }
  emit_call(call, function->body, call.n_arguments);
}

void ExpressionCompiler::add_name(const ExpressionItem& name) {
  const std::string folded = fold(name.text);
  const auto position_in = [&](std::span<const std::string> names) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), folded) - names.begin());
  };
  const std::size_t local = position_in(locals_), input = position_in(inputs_);
  if (local < locals_.size() || input < inputs_.size()) {
    const bool is_local = local < locals_.size();
    return emit(name, is_local ? Kind::local : Kind::input, is_local ? local : input);
  }
  if (const auto constant = find_expression_constant(folded)) return emit(name, Kind::number, 0, *constant);
  std::vector<std::string> known(inputs_.begin(), inputs_.end());
  known.insert(known.end(), locals_.begin(), locals_.end());
  std::string hint = name.text.size() > 2 ? suggest(name.text, known) : "";
  if (hint.empty()) hint = fmt::format("it may read {}", fmt::join(known, " "));
  fail_at(name, fmt::format("unknown name '{}' in the expression", name.text), std::move(hint));
}

Expression compile_expression(const DeckExpression& expression, std::span<const std::string> inputs) {
  if (expression.error) throw *expression.error;
  return ExpressionCompiler(inputs).compile(expression.items);
}

}  // namespace contactsim

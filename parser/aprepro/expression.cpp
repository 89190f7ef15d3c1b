// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/expression.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "core/base/names.hpp"
#include "parser/aprepro/calls.hpp"
#include "parser/aprepro/control.hpp"
#include "parser/aprepro/operators.hpp"
#include "parser/text/expression_grammar.hpp"

namespace contactsim {

namespace {

using Item = ExpressionItem;
using ItemKind = ExpressionItem::Kind;

/// The stack on which the items of one expression act.
class Evaluator {
 public:
  explicit Evaluator(ApreproState& state) : state_(state) {}
  ApreproValue evaluate(std::span<const Item> items);

 private:
  void act(const Item& item);
  void combine_two(const Item& op);
  void call(const Item& name);
  void choose(const Item& question);
  ApreproValue value_of(const Item& name);
  ApreproValue assign(const Item& name, ApreproValue value);
  void charge(std::size_t work, const Item& at);
  ApreproValue take();

  ApreproState& state_;
  std::vector<ApreproValue> values_;
};

ApreproValue Evaluator::evaluate(std::span<const Item> items) {
  values_.reserve(items.size());
  for (const Item& item : items) act(item);
  return take();
}

ApreproValue Evaluator::take() {
  ApreproValue value = std::move(values_.back());
  values_.pop_back();
  return value;
}

void Evaluator::act(const Item& item) {
  switch (item.kind) {
    case ItemKind::number:
    case ItemKind::string:
    case ItemKind::name:
      values_.push_back(value_of(item));
      break;
    case ItemKind::call:
      return call(item);
    case ItemKind::prefix:
      values_.back() = combine(item, values_.back());
      break;
    case ItemKind::binary:
      return combine_two(item);
    case ItemKind::store:
      values_.back() = assign(item, values_.back());
      break;
    case ItemKind::drop:
      values_.pop_back();
      break;
    case ItemKind::copy:
      values_.push_back(ApreproValue(values_.back()));
      break;
    case ItemKind::swap:
      std::swap(values_.back(), values_[values_.size() - 2]);
      break;
    case ItemKind::choose:
    case ItemKind::otherwise:
      break;  // both sides are evaluated
    case ItemKind::chosen:
      return choose(item);
  }
}

void Evaluator::combine_two(const Item& op) {
  const ApreproValue right = take();
  values_.back() = combine(values_.back(), op, right);
  if (const std::string* text = std::get_if<std::string>(&values_.back())) charge(text->size(), op);
}

void Evaluator::choose(const Item& question) {
  ApreproValue if_false = take(), if_true = take();
  if (if_true.index() != if_false.index()) fail_at(question, "'?' chooses between a number and a string");
  values_.back() = is_true(values_.back()) ? std::move(if_true) : std::move(if_false);
}

void Evaluator::call(const Item& name) {
  const ApreproFunction* function = find_aprepro_function(name.text);
  if (function == nullptr) {
    std::vector<std::string> known = aprepro_control_words();
    for (const ApreproFunction& row : aprepro_functions()) known.emplace_back(row.name);
    fail_at(name, fmt::format("unknown function '{}'", name.text), suggest(name.text, known));
  }
  const auto first = values_.end() - static_cast<std::ptrdiff_t>(name.n_arguments);
  ApreproValue value = call_aprepro_function(*function, name, {first, values_.end()}, state_);
  values_.erase(first, values_.end());
  values_.push_back(std::move(value));
}

void Evaluator::charge(std::size_t work, const Item& at) {
  state_.work += work;
  if (state_.work > state_.max_work) fail_at(at, "the deck expands without end, or to too much");
}

ApreproValue Evaluator::value_of(const Item& name) {
  if (name.kind == ItemKind::number) return name.number;
  if (name.kind == ItemKind::string) return name.text;
  if (const ApreproValue* value = state_.variables.find(name.text)) {
    if (const std::string* text = std::get_if<std::string>(value)) charge(text->size(), name);
    return *value;
  }
  const bool has_likeness = name.text.size() > 2;
  std::vector<std::string> known = state_.variables.names();
  for (const std::string& word : aprepro_control_words()) known.push_back(word);
  constexpr std::size_t cost_of_comparing = 100;
  charge(cost_of_comparing * known.size(), name);
  state_.warn("aprepro-undefined",
              {name.offset, static_cast<int>(name.text.size()), fmt::format("'{}' is not defined", name.text),
               has_likeness ? suggest(name.text, known) : ""});
  return 0.0;
}

ApreproValue Evaluator::assign(const Item& name, ApreproValue value) {
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

ApreproValue evaluate_aprepro(std::span<const ExpressionItem> expression, ApreproState& state) {
  return Evaluator(state).evaluate(expression);
}

ApreproValue evaluate_aprepro(std::string_view expression, std::size_t base, ApreproState& state) {
  state.work += expression.size();
  return evaluate_aprepro(parse_expression(expression, ExpressionDialects::aprepro, base), state);
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/global_expression.hpp"

#include <algorithm>

namespace contactsim {

namespace {

// The names that an expression reads, in order of first mention.
std::vector<std::string> names_in(const DeckExpression& expression) {
  std::vector<std::string> names;
  for (const ExpressionItem& item : expression.items) {
    if (item.kind != ExpressionItem::Kind::name) continue;
    std::string name = fold(item.text);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  return names;
}

// The global number of a name: a scalar, or the component that the name's ending tells.
std::optional<VariableSelection> find_global_number(const OutputVariables& variables,
                                                    const std::string& name) {
  const OutputVariable* whole = variables.find(FieldLocation::global, canonical_variable_name(name));
  if (whole != nullptr && whole->n_components == 1) return VariableSelection{whole, {}, {}};
  return find_by_ending(variables, FieldLocation::global, name);
}

}  // namespace

GlobalExpression::GlobalExpression(const DeckExpression& expression, const OutputVariables& variables) {
  std::vector<std::string> names;
  for (std::string& name : names_in(expression)) {
    // Others are constants, names that the expression sets, or unknown to the compiler too.
    const auto selection = find_global_number(variables, name);
    if (!selection) continue;
    inputs_.push_back(*selection);
    names.push_back(std::move(name));
  }
  expression_ = compile_expression(expression, names);
}

double GlobalExpression::evaluate(const OutputContext& context) const {
  std::vector<double> numbers(inputs_.size());
  for (std::size_t i = 0; i < inputs_.size(); ++i)
    fill(inputs_[i], context, EntityRange{}, std::span(numbers).subspan(i, 1));
  return expression_.evaluate(numbers);
}

bool GlobalExpression::reads_all() const {
  return std::ranges::any_of(inputs_,
                             [](const VariableSelection& input) { return input.variable->reads_all; });
}

}  // namespace contactsim

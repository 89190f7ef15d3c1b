// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/functions/expression.hpp"
#include "core/output/variable_selection.hpp"

namespace contactsim {

/// An expression of the deck over global variables: COMPUTE GLOBAL g FROM EXPRESSION. A scalar is read by its
/// name, a component with its ending: momentum_x.
class GlobalExpression {
 public:
  /// Throws ExpressionError. The variables must outlive it.
  GlobalExpression(const DeckExpression& expression, const OutputVariables& variables);

  double evaluate(const OutputContext& context) const;
  /// Whether it reads globals that are found from all nodes or elements.
  bool reads_all() const;

 private:
  std::vector<VariableSelection> inputs_;
  Expression expression_;
};

}  // namespace contactsim

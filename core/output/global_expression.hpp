// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

#include "core/functions/expression.hpp"
#include "core/output/variable_pick.hpp"

namespace contactsim {

/// An expression of the deck over global variables: COMPUTE GLOBAL g FROM EXPRESSION. A scalar is read by its
/// name, a component with its ending: momentum_x.
class GlobalExpression {
 public:
  /// Throws ExpressionError. The variables must outlive it.
  GlobalExpression(std::string_view text, const RunVariables& variables);

  double evaluate(const OutputMoment& moment) const;

 private:
  std::vector<VariablePick> inputs_;
  Expression expression_;
};

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "core/functions/expression.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace contactsim {

double Expression::evaluate(std::span<const double> inputs) const {
  // Assigned names live at the front of the same array; the compiler has counted how far the stack grows.
  using StepKind = ExpressionStep::Kind;
  std::array<double, max_expression_values> values;
  double* top = values.data() + n_locals_;
  for (std::size_t next = 0; next < steps_.size(); ++next) {
    const ExpressionStep& step = steps_[next];
    switch (step.kind) {
      case StepKind::number:
        *top++ = step.number;
        break;
      case StepKind::input:
        assert(step.index < inputs.size());
        *top++ = inputs[step.index];
        break;
      case StepKind::local:
        *top++ = values[step.index];
        break;
      case StepKind::store:
        values[step.index] = top[-1];
        break;
      case StepKind::drop:
        --top;
        break;
      case StepKind::call:
        top -= step.index;
        *top = step.body({top, step.index});
        ++top;
        break;
      case StepKind::jump:
        next = step.index - 1;
        break;
      case StepKind::jump_if_false:
        if (*--top == 0.0) next = step.index - 1;
        break;
    }
  }
  return top[-1];
}

bool Expression::is_constant() const {
  return std::none_of(steps_.begin(), steps_.end(),
                      [](const ExpressionStep& step) { return step.kind == ExpressionStep::Kind::input; });
}

}  // namespace contactsim

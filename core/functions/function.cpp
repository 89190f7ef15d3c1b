// SPDX-License-Identifier: BSD-3-Clause
#include "core/functions/function.hpp"

#include <cassert>

namespace contactsim {

double Function::evaluate(double abscissa) const {
  assert(inputs_.empty());
  return evaluate(std::span<const double>(&abscissa, 1));
}

double Function::evaluate(std::span<const double> inputs) const {
  if (const double* value = std::get_if<double>(&form_)) return *value;
  if (const auto* analytic = std::get_if<Analytic>(&form_)) {
    return analytic->y_scale * (analytic->expression.evaluate(inputs) + analytic->y_offset);
  }
  assert(inputs.size() == 1);
  if (const auto* linear = std::get_if<PiecewiseLinear>(&form_)) return linear->evaluate(inputs[0]);
  return std::get<PiecewiseConstant>(form_).evaluate(inputs[0]);
}

bool Function::is_constant() const {
  const auto* analytic = std::get_if<Analytic>(&form_);
  return std::holds_alternative<double>(form_) || (analytic != nullptr && analytic->expression.is_constant());
}

}  // namespace contactsim

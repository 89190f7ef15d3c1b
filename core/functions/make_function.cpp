// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/functions/expression_place.hpp"
#include "core/functions/function.hpp"

namespace contactsim {

namespace {

/// The components a source's variable has, as suffixes of its name; one "" of a scalar.
std::vector<std::string_view> components_of(ExpressionSource source) {
  switch (source) {
    case ExpressionSource::nodal_vector:
    case ExpressionSource::element_vector:
      return {"x", "y", "z"};
    case ExpressionSource::nodal_sym_tensor:
    case ExpressionSource::element_sym_tensor:
      return {"xx", "yy", "zz", "xy", "yz", "zx"};
    case ExpressionSource::nodal_tensor:
    case ExpressionSource::element_tensor:
      return {"xx", "yy", "zz", "xy", "yz", "zx", "yx", "zy", "xz"};
    case ExpressionSource::global:
    case ExpressionSource::nodal:
    case ExpressionSource::element:
    case ExpressionSource::face:
      break;
  }
  return {""};
}

}  // namespace

/// Turns one definition into a Function; each step gives nothing after adding an error.
class FunctionMaker {
 public:
  FunctionMaker(const FunctionDefinition& definition, Diagnostics& diagnostics)
      : definition_(definition), diagnostics_(diagnostics) {}
  std::optional<Function> make() const;

 private:
  std::optional<Function> make_constant() const;
  std::optional<Function> make_table() const;
  std::optional<Function> make_analytic() const;
  std::optional<std::vector<FunctionPoint>> read_points() const;
  bool check_point(const FunctionValue& value, const FunctionPoint& point, const FunctionValue* before,
                   std::span<const FunctionPoint> points) const;
  std::optional<std::vector<FunctionInput>> read_inputs() const;
  std::optional<Expression> compile(std::span<const FunctionInput> inputs) const;

  std::nullopt_t fail(const DeckLocation& at, std::string_view what, std::string hint = "") const {
    diagnostics_.add_error(at, fmt::format("the function '{}' {}", definition_.name.text, what),
                           std::move(hint));
    return std::nullopt;
  }
  std::nullopt_t fail(std::string_view what, std::string hint = "") const {
    return fail(definition_.name.location, what, std::move(hint));
  }
  double scaled_y(double y) const { return definition_.y_scale * (y + definition_.y_offset); }

  const FunctionDefinition& definition_;
  Diagnostics& diagnostics_;
};

std::optional<Function> FunctionMaker::make() const {
  if (!definition_.type) return fail("has no type", "add a line such as TYPE = ANALYTIC");
  switch (*definition_.type) {
    case FunctionType::constant:
      return make_constant();
    case FunctionType::piecewise_linear:
    case FunctionType::piecewise_constant:
      return make_table();
    case FunctionType::analytic:
      return make_analytic();
    case FunctionType::piecewise_analytic:
    case FunctionType::piecewise_multivariate:
    case FunctionType::multicolumn_piecewise_linear:
    case FunctionType::xtable:
    case FunctionType::polynomial:
    case FunctionType::haversine_spike:
      break;
  }
  return fail(definition_.type_location, "has a type that is not supported",
              "use piecewise linear or analytic");
}

std::optional<Function> FunctionMaker::make_constant() const {
  if (definition_.values.size() != 1) {
    return fail(fmt::format("of type constant needs one value, found {}", definition_.values.size()));
  }
  const FunctionValue& value = definition_.values.front();
  const bool is_single = std::isnan(value.abscissa) && value.further.empty() && value.expression.empty();
  if (!is_single) return fail(value.location, "of type constant needs one number");
  const double y = scaled_y(value.ordinate);
  if (!std::isfinite(y)) return fail(value.location, "has a scaled value that is not finite");
  return Function(y);
}

std::optional<Function> FunctionMaker::make_table() const {
  if (!(definition_.x_scale > 0.0)) {
    return fail(fmt::format("has an X SCALE of {}, which is not positive", definition_.x_scale),
                "write the abscissae as they are meant");
  }
  auto points = read_points();
  if (!points) return std::nullopt;
  if (!std::isfinite(points->back().x - points->front().x)) return fail("has abscissae too far apart");
  if (definition_.type == FunctionType::piecewise_linear)
    return Function(PiecewiseLinear(std::move(*points), definition_.at_discontinuity));
  return Function(PiecewiseConstant(std::move(*points), definition_.at_discontinuity));
}

/// Of the lines only the first wrong one is reported: those after it are likely wrong in the same way.
std::optional<std::vector<FunctionPoint>> FunctionMaker::read_points() const {
  if (definition_.values.empty()) return fail("has no values", "add a VALUES block");
  std::vector<FunctionPoint> points;
  points.reserve(definition_.values.size());
  const FunctionValue* before = nullptr;
  for (const FunctionValue& value : definition_.values) {
    const bool is_pair = !std::isnan(value.abscissa) && !std::isnan(value.ordinate) && value.further.empty();
    if (!is_pair) return fail(value.location, "needs two numbers on each line");
    if (before != nullptr && value.abscissa < before->abscissa) {
      return fail(value.location, fmt::format("has an abscissa that decreases from {} to {}",
                                              before->abscissa, value.abscissa));
    }
    const FunctionPoint point{definition_.x_scale * (value.abscissa + definition_.x_offset),
                              scaled_y(value.ordinate)};
    if (!check_point(value, point, before, points)) return std::nullopt;
    points.push_back(point);
    before = &value;
  }
  return points;
}

/// Two points of one abscissa are a jump of straight lines; a third would never count.
///   before  the line before, or null
///   points  those of the lines before
bool FunctionMaker::check_point(const FunctionValue& value, const FunctionPoint& point,
                                const FunctionValue* before, std::span<const FunctionPoint> points) const {
  if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
    fail(value.location, "has a scaled value that is not finite");
    return false;
  }
  if (before == nullptr || point.x > points.back().x) return true;
  const bool may_jump =
      definition_.type == FunctionType::piecewise_linear && value.abscissa == before->abscissa;
  const std::size_t n = points.size();
  if (may_jump && (n < 2 || points[n - 2].x < point.x)) return true;
  fail(value.location, fmt::format("has the abscissa {} {}", point.x, may_jump ? "three times" : "twice"),
       may_jump ? "a jump has the value before it and the one after it" : "each point needs one of its own");
  return false;
}

std::optional<std::vector<FunctionInput>> FunctionMaker::read_inputs() const {
  std::vector<FunctionInput> inputs;
  for (const ExpressionVariable& variable : definition_.variables) {
    for (const std::string_view component : components_of(variable.source)) {
      std::string name = fold(variable.name.text);
      if (!component.empty()) name += fmt::format("_{}", component);
      const bool is_taken =
          std::any_of(inputs.begin(), inputs.end(), [&](const FunctionInput& in) { return in.name == name; });
      if (is_taken) return fail(variable.name.location, fmt::format("has two variables named '{}'", name));
      inputs.push_back({std::move(name), variable.source, variable.variable, component});
    }
  }
  return inputs;
}

std::optional<Function> FunctionMaker::make_analytic() const {
  if (!definition_.expression) return fail("has no expression", "add EVALUATE EXPRESSION");
  if (definition_.x_scale != 1.0 || definition_.x_offset != 0.0) {
    return fail("of type analytic takes no X SCALE and no X OFFSET", "put them into the expression");
  }
  auto inputs = read_inputs();
  if (!inputs) return std::nullopt;
  auto expression = compile(*inputs);
  if (!expression) return std::nullopt;
  Function function(Function::Analytic{std::move(*expression), definition_.y_scale, definition_.y_offset});
  function.inputs_ = std::move(*inputs);
  if (function.is_constant() && !std::isfinite(function.evaluate(std::span<const double>()))) {
    return fail(locate(*definition_.expression, 0), "has no finite value");
  }
  return function;
}

std::optional<Expression> FunctionMaker::compile(std::span<const FunctionInput> inputs) const {
  std::vector<std::string> names;
  for (const FunctionInput& input : inputs) names.push_back(input.name);
  if (names.empty()) names.emplace_back("x");
  const DeckExpression& expression = *definition_.expression;
  try {
    return compile_expression(expression, names);
  } catch (const ExpressionError& error) {
    diagnostics_.add_error(locate(expression, error.offset),
                           fmt::format("the function '{}': {}", definition_.name.text, error.text),
                           error.hint, error.length);
    return std::nullopt;
  }
}

std::optional<Function> make_function(const FunctionDefinition& definition, Diagnostics& diagnostics) {
  return FunctionMaker(definition, diagnostics).make();
}

std::optional<double> find_jump(const FunctionDefinition& definition) {
  const auto jump = std::ranges::adjacent_find(definition.values, {}, &FunctionValue::abscissa);
  if (jump == definition.values.end()) return std::nullopt;
  return jump->abscissa;
}

std::optional<Function> make_named_function(const DeckName& name,
                                            std::span<const FunctionDefinition> definitions,
                                            Diagnostics& diagnostics) {
  const auto found =
      std::find_if(definitions.begin(), definitions.end(),
                   [&](const FunctionDefinition& definition) { return definition.name == name; });
  if (found != definitions.end()) return make_function(*found, diagnostics);
  if (fold(name.text) == constant_one_function) return Function(1.0);
  std::vector<std::string> known{constant_one_function};
  for (const FunctionDefinition& definition : definitions) known.push_back(definition.name.text);
  diagnostics.add_error(name.location, fmt::format("there is no function '{}'", name.text),
                        suggest(name.text, known), std::max(1, static_cast<int>(name.text.size())));
  return std::nullopt;
}

}  // namespace contactsim

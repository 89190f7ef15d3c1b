// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/definition/function.hpp"
#include "parser/text/expression_grammar.hpp"

namespace contactsim {

/// A definition named f with the points of a table, point i at line i + 1 of the file a.i.
inline FunctionDefinition table_function(FunctionType type,
                                         const std::vector<std::pair<double, double>>& points) {
  FunctionDefinition definition;
  const auto file = std::make_shared<const SourceFile>(SourceFile{"a.i", ""});
  definition.name = {"f", {file, 100, 1, nullptr}};
  definition.type = type;
  int line = 0;
  for (const auto& [x, y] : points) {
    FunctionValue value;
    value.location = {file, ++line, 1, nullptr};
    value.abscissa = x;
    value.ordinate = y;
    definition.values.push_back(value);
  }
  return definition;
}

/// An analytic definition named f, its expression at the start of the file a.i.
inline FunctionDefinition analytic_function(const std::string& expression) {
  FunctionDefinition definition;
  const auto file = std::make_shared<const SourceFile>(SourceFile{"a.i", "\"" + expression + "\"\n"});
  definition.name = {"f", {file, 100, 1, nullptr}};
  definition.type = FunctionType::analytic;
  definition.expression = read_deck_expression({file, 1, 1, nullptr}, expression);
  return definition;
}

}  // namespace contactsim

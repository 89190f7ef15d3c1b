// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/functions/function.hpp"
#include "core/output/variable_selection.hpp"

namespace contactsim {

/// A variable as one word of the deck: v, v(x) or v(x,3).
VariableReference split_reference(const DeckName& word);

/// A function of the deck over the variables of a run.
class VariableFunction {
 public:
  VariableFunction(Function function, std::vector<VariableSelection> inputs)
      : function_(std::move(function)), inputs_(std::move(inputs)) {}

  /// Sets the values at a range of nodes or elements, or at the range {0, 0, 1} the one of the whole. A
  /// function that reads no variable takes the time.
  ///   values  [range.count]
  void evaluate(const OutputContext& context, const EntityRange& range, std::span<double> values) const;

 private:
  Function function_;
  std::vector<VariableSelection> inputs_;  // of one component each
};

/// A function for values at a location; it may read variables of the same location and globals. Nothing when
/// it reads others: a warning is added.
std::optional<VariableFunction> make_variable_function(Function function, FieldLocation location,
                                                       const OutputVariables& variables,
                                                       Diagnostics& diagnostics);

}  // namespace contactsim

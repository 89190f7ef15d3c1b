// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "core/output/requested_fields.hpp"

namespace contactsim {

/// Single values of a run for HISTORY and HEARTBEAT OUTPUT: globals, and variables of one node or element by
/// id or nearest to a point of the mesh. All fields are global ones of a file. What is not known is left out
/// with a warning; an id that the mesh does not have is an error. The variables must outlive the fields.
///   separator  between the names of variables and components
/// Source: Sierra/SM 5.22, 9.7 and 9.8.
RequestedFields make_single_values(const OutputVariables& variables,
                                   std::span<const VariableRequest> requests, const std::string& separator,
                                   Diagnostics& diagnostics);

/// The names of all values, component by component, in the order of evaluate_all().
std::vector<std::string> value_names(const RequestedFields& fields);

/// Their dimensions in the same order, "[?]" of what the deck computes in a way that does not tell.
std::vector<std::string> value_dimensions(const RequestedFields& fields);

/// All values at one time, field by field. On several ranks all call it alike.
std::vector<double> evaluate_all(RequestedFields& fields, const OutputContext& context);

}  // namespace contactsim

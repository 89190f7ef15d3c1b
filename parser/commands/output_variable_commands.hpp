// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/output_variable.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// Which places an output may ask for variables at.
enum class RequestPlaces {
  parts,    ///< the model or some of its parts: RESULTS OUTPUT
  entities  ///< single nodes, elements, ... too: HISTORY and HEARTBEAT OUTPUT
};

/// The lines that ask for variables: NODAL VARIABLES = ..., the short NODAL ..., the older VARIABLE = NODAL
/// ...
std::vector<Row<std::vector<VariableRequest>>> variable_request_rows(RequestPlaces places);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/definition/death.hpp"
#include "core/definition/output_variable.hpp"
#include "parser/binding/arguments.hpp"

namespace contactsim {

/// Reads v, v(component) or v(component,integration point); a component or point of ":" or "*" means all.
/// Throws ArgumentError.
VariableReference read_variable(Arguments& arguments);

/// Reads <variable> <op> <number>, where op is one of < <= = >= >.
/// Throws ArgumentError.
VariableTest read_variable_test(Arguments& arguments);

/// Reads the word NODAL, NODE, ELEMENT, EDGE, FACE, GLOBAL, NODESET, SURFACE or SIDESET.
/// Throws ArgumentError.
VariableLocation read_location(Arguments& arguments);

}  // namespace contactsim

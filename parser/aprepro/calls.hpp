// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parser/aprepro/functions.hpp"

namespace contactsim {

/// Calls a function. Throws ExpressionError at the function's name when it is refused, when number or types
/// of arguments are wrong, and when its value is not a finite number.
ApreproValue call_aprepro_function(const ApreproFunction& function, const ExpressionItem& name,
                                   ApreproFunction::Arguments arguments, ApreproState& state);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "core/definition/death.hpp"

namespace contactsim {

/// Whether a value meets a test. One that is not a number meets none.
bool holds(const VariableTest& test, double value);

/// "<", "<=", ...
std::string_view symbol(Comparison comparison);

}  // namespace contactsim

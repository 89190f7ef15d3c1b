// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/definition/parameter_values.hpp"
#include "parser/binding/table.hpp"

namespace contactsim {

/// The table of the parameters of a law, which reads into their values.
Table<ParameterValues> make_parameter_table(std::span<const Parameter> parameters);

}  // namespace contactsim

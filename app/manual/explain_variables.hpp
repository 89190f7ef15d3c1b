// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

namespace contactsim {

/// The reference of output variables, made from the rows that fill them: those whose name holds the words,
/// joined by underscores; all of them for the words "output variables". "" when there is none.
std::string explain_variables(std::span<const std::string> words);

}  // namespace contactsim

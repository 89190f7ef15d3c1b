// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/definition/simulation.hpp"

namespace contactsim::test {

/// What of a definition that was read without an error cannot be: a time or a parameter that is no number, a
/// function that cannot be made and is not reported. "" when nothing is.
std::string find_definition_harm(const SimulationDefinition& definition);

}  // namespace contactsim::test

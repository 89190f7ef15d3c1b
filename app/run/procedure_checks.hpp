// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/diagnostics.hpp"
#include "core/definition/declarations.hpp"

namespace contactsim {

/// What the deck alone shows of procedures that follow each other. Errors: PROCEDURAL TRANSFER in the first,
/// files of one name in two. Warnings: a procedure that starts from the mesh,
/// and one that takes over a state of another time.
void check_procedures(const SimulationDefinition& definition, Diagnostics& diagnostics);

}  // namespace contactsim

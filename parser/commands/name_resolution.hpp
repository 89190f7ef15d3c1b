// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/definition/simulation.hpp"
#include "parser/binding/table.hpp"

namespace contactsim {

/// Looks up every name that the deck uses, after all of it is bound, so that names may be used before they
/// are defined. A name that is missing is an error at the reference, a second definition of one name an error
/// there. What is used, directly or through other definitions, by a region or a time control is checked; of
/// what is not used only the held problems are told, as warnings ("deck-unused"). In a deck of contact alone
/// a name may be defined elsewhere, and every finite element model is used.
///   held  the problems of definitions that were held back while binding
void resolve_names(const SimulationDefinition& simulation, const std::vector<HeldDiagnostics>& held,
                   Diagnostics& diagnostics);

}  // namespace contactsim

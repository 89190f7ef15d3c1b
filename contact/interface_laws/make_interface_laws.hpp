// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/interface_laws/pair_interface_law.hpp"
#include "contact/surfaces/surface_pairs.hpp"
#include "core/definition/friction.hpp"

namespace contactsim {

/// What friction models refer to.
struct LawScope {
  std::span<const FrictionModel> models;
  std::span<const FunctionDefinition> functions;
  std::span<const TimeSteppingBlock> time_stepping_blocks;
};

/// The friction models of pairs, ready for the loops. Errors: functions that are not piecewise linear where
/// they must be or do not soften where they must; a FAILED MODEL that holds; a HYBRID or TIME VARIANT model
/// that selects one of these; a capacity or critical gap that is missing; a pressure that falls.
///   diagnostics  gets each error once for an interaction
IndexedVector<PairIndex, PairInterfaceLaw> make_pair_laws(std::span<const SurfacePair> pairs,
                                                          const LawScope& scope, Diagnostics& diagnostics);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/definition/region.hpp"
#include "core/diagnostics.hpp"

namespace contactsim {

/// The names that a region may use and that are defined outside it, in the deck's spelling. Built-in names,
/// such as SIERRA_CONSTANT_FUNCTION_ONE, need not be listed.
struct OutsideNames {
  std::vector<std::string> functions, materials, periods, directions, axes, rigid_bodies, output_schedulers;
  bool are_known =
      true;  ///< false for a deck that is a fragment: names that are not in it are then not checked
};

/// Checks every name that the region's commands use against what is defined: friction models, contact
/// surfaces, functions, periods, directions, axes. No mesh is needed: names of mesh parts are not looked at,
/// and a surface that SKIN ALL BLOCKS may make is left to the mesh stage. Errors stand at the reference.
void resolve_region_names(const Region& region, const OutsideNames& outside, Diagnostics& diagnostics);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/diagnostics.hpp"
#include "core/definition/region.hpp"
#include "parser/binding/known_names.hpp"

namespace contactsim {

/// The names that a region may use and that are defined outside it. Looking a name up marks it as used.
struct OutsideNames {
  KnownNames functions{"function"};
  KnownNames materials{"material"};
  KnownNames periods{"time stepping block"};
  KnownNames directions{"direction"};
  KnownNames axes{"axis"};
  KnownNames coordinate_systems{"coordinate system"};
  KnownNames rigid_bodies{"rigid body"};
  KnownNames output_schedulers{"output scheduler"};
};

/// Checks every name that the region's commands use against what is defined: friction models, contact
/// surfaces, functions, periods, directions, axes. No mesh is needed: names of mesh parts are not looked at,
/// and a surface that SKIN ALL BLOCKS may make is left to the mesh stage. Errors stand at the reference.
void resolve_region_names(const Region& region, OutsideNames& outside, Diagnostics& diagnostics);

}  // namespace contactsim

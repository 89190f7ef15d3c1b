// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/contact_surface.hpp"
#include "core/definition/procedure.hpp"
#include "core/diagnostics.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Adds an error for everything in the region that would change the motion and that this version does not act
/// on, and a warning for what would not.
void refuse_what_is_missing(const Procedure& procedure, const Region& region, Diagnostics& diagnostics);

/// Adds an error for every contact surface with shells, lines or particles: their contact is resolved, not
/// enforced.
void refuse_lofts(const ContactSurfaces& surfaces, const Mesh& mesh, Diagnostics& diagnostics);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/surfaces/contact_surface.hpp"
#include "core/base/diagnostics.hpp"
#include "core/definition/declarations.hpp"

namespace contactsim {

/// Checks that every contact surface that interactions and options name is there, those of SKIN ALL BLOCKS
/// included. A missing one is an error at the reference, with the nearest surface.
void check_surface_names(const ContactDefinition& contact, const ContactSurfaces& surfaces,
                         Diagnostics& diagnostics);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/surfaces/contact_surface.hpp"
#include "contact/surfaces/ownership_rules.hpp"
#include "core/base/diagnostics.hpp"
#include "core/definition/declarations.hpp"

namespace contactsim {

/// The surfaces of the start, while every element lives: each face, lofted element and node of the mesh goes
/// where the rules say. SurfaceTracker updates them.
ContactSurfaces resolve_surfaces(const OwnershipRules& rules, const Mesh& mesh);

/// The same of a contact definition.
///   names        analytic objects and mesh aliases of the region
///   diagnostics  gets an error for every wrong name; the result is then not complete
/// Throws FileError when contact needs a block whose element type is not known.
/// Time O(n log n) in faces and claims. Source: Sierra/SM 5.22, 8.4.
ContactSurfaces resolve_surfaces(const ContactDefinition& contact, const RegionNames& names, const Mesh& mesh,
                                 Diagnostics& diagnostics);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "contact/surfaces/contact_surface.hpp"
#include "contact/surfaces/surface_request.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Sets the warnings of surfaces: what was left out, claims lost, empty surfaces.
///   requests  that the surfaces were made by
void set_surface_warnings(std::span<const SurfaceRequest> requests, const Mesh& mesh,
                          ContactSurfaces& result);

}  // namespace contactsim

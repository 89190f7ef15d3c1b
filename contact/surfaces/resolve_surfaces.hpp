// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

#include "contact/surfaces/contact_surface.hpp"
#include "contact/surfaces/surface_request.hpp"
#include "core/base/diagnostics.hpp"
#include "core/definition/declarations.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Resolves the surfaces of a contact definition: skins and lofts the present blocks, then gives every face,
/// lofted element and node to the first surface in deck order that claims it.
///   names        analytic objects and mesh aliases of the region
///   alive        [n_elements] 0 or 1, or empty when all live; dead elements count as if they had never been
///   diagnostics  gets an error for every wrong name; the result is then not complete
/// Throws FileError when contact needs a block whose element type is not known.
/// Time O(n log n) in faces and claims. Source: Sierra/SM 5.22, 8.4.
ContactSurfaces resolve_surfaces(const ContactDefinition& contact, const RegionNames& names, const Mesh& mesh,
                                 std::span<const std::uint8_t> alive, Diagnostics& diagnostics);

/// The subset that a face of the surface goes to, from 1; 0 when it stays.
std::uint32_t choose_subset(const std::vector<SubsetRequest>& subsets, const Mesh& mesh, ElementSide face);

/// Sets the warnings of resolved surfaces: what was left out, claims lost, empty surfaces.
///   requests  that the surfaces were made by
void set_surface_warnings(std::span<const SurfaceRequest> requests, const Mesh& mesh,
                          ContactSurfaces& result);

}  // namespace contactsim

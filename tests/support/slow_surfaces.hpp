// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

#include "contact/surfaces/contact_surface.hpp"
#include "core/definition/declarations.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim::test {

/// The slow and obvious resolution of contact surfaces, to compare others with: one request after the other
/// claims all that it names of the living elements, and what nobody has is its own.
///   alive  [n_elements] 0 or 1
/// Throws std::logic_error when the definition names what the mesh has not.
/// Source: Sierra/SM 5.22, 8.4.
ContactSurfaces resolve_slowly(const ContactDefinition& contact, const Mesh& mesh,
                               std::span<const std::uint8_t> alive);

}  // namespace contactsim::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "contact/surfaces/contact_surface.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// The sides by which results show a contact surface: its faces, and both sides of shells that it lofts.
/// In the order of the file.
std::vector<ElementSide> sides_of_surface(const ContactSurface& surface, const Mesh& mesh);

/// The nodes by which results show what has no sides: those of a surface of nodes, and of lines, particles
/// and elements QUAD that it lofts. In the order of the file.
std::vector<NodeIndex> nodes_of_surface(const ContactSurface& surface, const Mesh& mesh);

}  // namespace contactsim

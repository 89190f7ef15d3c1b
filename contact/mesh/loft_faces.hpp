// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/mesh/contact_mesh.hpp"

namespace contactsim {

/// Adds the points of all bricks to the contact nodes, after those that are nodes of the mesh, and says which
/// contact nodes hang on the same node.
void add_loft_points(const ContactModel& contact, const Mesh& mesh, ContactMesh& made);

/// Adds what a surface has of lofts: faces and nodes of bricks, capsules with the spheres around their ends,
/// particles.
///   made  has all contact nodes
void add_lofts(const ContactModel& contact, const Mesh& mesh, std::uint32_t surface, ContactMesh& made);

}  // namespace contactsim

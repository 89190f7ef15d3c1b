// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/contact_faces.hpp"

namespace contactsim {

/// Adds the points of all bricks to the contact nodes, after those that are nodes of the mesh, and says which
/// contact nodes hang on the same node.
void add_loft_points(const ContactModel& contact, const Mesh& mesh, ContactFaces& made);

/// Adds what a surface has of lofts: faces and nodes of bricks, rods with the balls around their ends,
/// particles.
///   made  has all contact nodes
void add_lofts(const ContactModel& contact, const Mesh& mesh, std::uint32_t surface, ContactFaces& made);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/mesh/contact_mesh.hpp"

namespace contactsim {

/// Adds the points of all bricks to the contact nodes, after those that are nodes of the mesh, and says which
/// contact nodes hang on the same node.
void add_loft_points(const ContactModel& contact, const Mesh& mesh, ContactMesh& made);

/// The least radius of the rods of any surface that meet at each node of the mesh; infinite where none does
/// [n_nodes], empty without rods [length].
std::vector<double> least_radii(const ContactModel& contact, const Mesh& mesh);

/// Adds what a surface has of lofts: faces and nodes of bricks, capsules with the spheres around their ends,
/// particles.
///   radii  least_radii()
///   made   has all contact nodes
void add_lofts(const ContactModel& contact, const Mesh& mesh, SurfaceIndex surface,
               std::span<const double> radii, ContactMesh& made);

}  // namespace contactsim

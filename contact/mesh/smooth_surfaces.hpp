// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "contact/mesh/contact_kinematics.hpp"
#include "contact/mesh/contact_model.hpp"

namespace contactsim {

/// Finds the smoothings that the pairs of a model ask for: the shapes of the deck, and for AUTO those fitted
/// to the mesh.
///   diagnostics  gets errors for axes through one point, and warnings of smoothings that nothing uses
///                ("smoothing-unused") or that smooth neither side of a pair ("smoothing-without-effect")
void find_smoothings(const SimulationDefinition& definition, const ContactDefinition& contact,
                     const Mesh& mesh, ContactModel& model, Diagnostics& diagnostics);

/// Fits the shapes of AUTO anew, to nodes that were moved before the first step. A surface of which fewer
/// parts fit then keeps the shapes that it had.
///   mesh  with the nodes moved
void refit_smoothings(const Mesh& mesh, ContactModel& model);

/// Finds which faces of a contact mesh stand for round surfaces, and those as they are at the start.
///   start  the faces at the start
void add_smooth_faces(const ContactModel& model, const ContactKinematics& start, ContactMesh& contact_mesh);

}  // namespace contactsim

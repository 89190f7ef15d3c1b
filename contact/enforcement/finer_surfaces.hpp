// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/mesh/contact_mesh.hpp"
#include "contact/mesh/contact_model.hpp"

namespace contactsim {

/// The surface of each pair that multipliers stand on, on one alone, since those of both would be more than
/// there is to be balanced: the one with the finer faces, or the softer one, so that the corners of a coarse
/// side need not bend the faces of a fine and stiff one, which makes the pressure of its nodes go up and
/// down. Of a plane or a surface of faces alone the other one. Source: Abaqus, choosing the secondary surface
/// of a contact pair.
IndexedVector<PairIndex, SurfaceIndex> find_finer_surfaces(const ContactModel& contact,
                                                           const ContactMesh& contact_mesh);

}  // namespace contactsim

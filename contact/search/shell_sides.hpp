// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/mesh/contact_mesh.hpp"

/// SIDES of a pair. Source: polarity of Abaqus' *CONTACT FORMULATION, MORIENT of OptiStruct's CONTACT.
namespace contactsim {

struct SurfacePair;

/// Whether a face is of a side of shells that takes part in a pair, or of no shell. Rims take part with both
/// sides alone.
bool takes_part(const SurfacePair& pair, const ContactFace& face, const ContactMesh& contact_mesh,
                const Mesh& mesh);
/// Whether some face of a surface node does; of a node without faces always.
bool takes_part(const SurfacePair& pair, const SurfaceNode& node, const ContactMesh& contact_mesh,
                const Mesh& mesh);

}  // namespace contactsim

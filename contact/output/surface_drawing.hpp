// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/mesh/contact_model.hpp"
#include "core/mesh/facet_mesh.hpp"

namespace contactsim {

/// All surfaces as facets to draw, one block per surface, in surface order. Spheres become 24 quadrilaterals,
/// analytic planes squares, nodes points.
FacetMesh draw_surfaces(const ContactModel& model, const Mesh& mesh);

}  // namespace contactsim

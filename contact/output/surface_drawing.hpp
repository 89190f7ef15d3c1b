// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "contact/mesh/contact_mesh.hpp"
#include "contact/mesh/contact_model.hpp"
#include "core/definition/contact_options.hpp"
#include "core/mesh/facet_mesh.hpp"

namespace contactsim {

/// All surfaces as facets to draw, one block per surface, in surface order. Spheres become 24 quadrilaterals,
/// analytic planes squares, nodes points. Then a block <surface>_edges of every surface with edges that meet
/// edges: its feature edges and the axes of its lines; a number follows where a surface has the name.
///   contact_mesh  of the model, with its edges chosen
FacetMesh draw_surfaces(const ContactModel& model, const Mesh& mesh, const ContactMesh& contact_mesh);
/// The same before a run.
///   options  of surfaces, which choose the edges
FacetMesh draw_surfaces(const ContactModel& model, const Mesh& mesh,
                        const std::vector<SurfaceOptions>& options);

}  // namespace contactsim

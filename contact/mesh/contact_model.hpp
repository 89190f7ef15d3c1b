// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "contact/lofting/loft.hpp"
#include "contact/smoothing/surface_shapes.hpp"
#include "contact/surfaces/contact_surface.hpp"
#include "contact/surfaces/surface_pairs.hpp"
#include "contact/surfaces/surface_request.hpp"
#include "core/base/diagnostics.hpp"
#include "core/definition/contact_surfaces.hpp"
#include "core/definition/declarations.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Contact as the deck and the mesh define it: who owns what, and the bodies around lofted elements. Changes
/// only when elements die.
struct ContactModel {
  ContactSurfaces surfaces;
  LoftGeometry loft;                             ///< of all lofted elements that surfaces own
  std::vector<SurfaceIndex> surface_of_facet;    ///< [n_loft_facets]
  std::vector<SurfaceIndex> surface_of_sphere;   ///< [n_loft_spheres]
  std::vector<SurfaceIndex> surface_of_capsule;  ///< [n_loft_capsules]
  std::vector<AnalyticPlane> planes;             ///< those of the region
  SurfacePairs pairs;                            ///< sorted by their surfaces
  std::vector<SmoothingShapes> smoothings;       ///< that pairs use
};

/// Resolves the surfaces of a region's contact definition, pairs them and builds their lofts.
///   diagnostics  gets an error for every wrong name and every block without a thickness or radius,
///                and what make_surface_pairs() reports
/// Throws FileError when contact needs a block whose element type is not known.
ContactModel make_contact_model(const SimulationDefinition& definition, const Region& region,
                                const Mesh& mesh, Diagnostics& diagnostics);

/// Lofts the elements that the model's surfaces own, in place of what was lofted before.
///   diagnostics  gets an error for every block without a thickness or radius
void make_lofts(const SimulationDefinition& definition, const Region& region, const Mesh& mesh,
                ContactModel& model, Diagnostics& diagnostics);

/// What the surface-making commands of the region's contact definition ask for, in their order.
std::vector<SurfaceRequest> find_surface_requests(const SimulationDefinition& definition,
                                                  const Region& region, const Mesh& mesh,
                                                  Diagnostics& diagnostics);

/// Only looks up the names of mesh parts in the region's contact surfaces, for decks that have other errors
/// as well.
void find_name_errors(const SimulationDefinition& definition, const Region& region, const Mesh& mesh,
                      Diagnostics& diagnostics);

}  // namespace contactsim

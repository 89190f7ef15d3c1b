// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/lofting/loft.hpp"
#include "contact/surfaces/contact_surface.hpp"
#include "core/base/diagnostics.hpp"
#include "core/definition/declarations.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// A lofted element and the contact surface that owns it.
struct OwnedElement {
  ElementIndex element;
  SurfaceIndex surface;
  auto operator<=>(const OwnedElement&) const = default;
};

/// Lofted elements of some contact surfaces.
struct OwnedElements {
  const SurfaceList& surfaces;
  std::span<const OwnedElement> elements;  ///< ascending
};

/// Thickness or radius of lofted elements, each from the first of: SURFACE OPTIONS of the contact definition
/// (BEAM RADIUS), the section of its block, the block's attribute on the mesh. A block that has none of them,
/// and a size that is not positive, are errors at the surface's command.
/// Returns [n_elements] of the owned ones; a size that could not be found is 0.
/// A line without a radius has that of a circle of its area. LET_CONTACT_CHOOSE bounds a shell's thickness.
/// Source: Sierra/SM 5.22, 8.4.8 and 8.9.
std::vector<LoftSize> find_loft_sizes(const SimulationDefinition& definition, const Region& region,
                                      const Mesh& mesh, const OwnedElements& owned, Diagnostics& diagnostics);

}  // namespace contactsim

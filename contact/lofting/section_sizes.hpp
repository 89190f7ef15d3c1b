// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/definition/declarations.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// What the section of a block says about the bodies around its elements.
struct SectionSize {
  std::optional<double> thickness;  ///< of shells, > 0 [length]
  std::optional<double> radius;     ///< of lines and particles, > 0 [length]
  double thickness_factor = 1.0;    ///< of the thickness, the section's or the mesh's, > 0 [1]
  double lofting_factor = 0.5;      ///< share of the thickness on the normal's side [1]
  std::string attribute;            ///< of the mesh that holds the thickness, "" for the usual one
};

/// The sizes that the sections of a region's blocks give. A block takes the section of any name that it has:
/// its own, that of an assembly that holds it, an alias of either.
/// Returns [n_blocks]; a block whose section says nothing, or that has none, has no thickness and no radius.
///
/// A truss becomes a cylinder of equal area; the cross-section of a beam is enclosed in a circle.
/// Source: Sierra/SM 5.22, 8.4.8; Abaqus general contact (radius of beams: circumscribed circle, of trusses:
/// equal area).
std::vector<SectionSize> find_section_sizes(const SimulationDefinition& definition, const Region& region,
                                            const Mesh& mesh);

/// Positions of the blocks whose section is one of point masses, springs, dampers or cohesive elements,
/// ascending.
std::vector<std::uint32_t> find_sizeless_blocks(const SimulationDefinition& definition, const Region& region,
                                                const Mesh& mesh);

/// Radius of a circle of this area [length].
double radius_of_area(double area);

}  // namespace contactsim

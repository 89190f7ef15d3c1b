// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/definition/section.hpp"
#include "core/elements/model_block.hpp"

namespace contactsim {

/// What makes a block of lines or particles besides the mesh and the material.
struct LineSetup {
  const ElementFormulation* element = nullptr;
  BeamShapeSettings beam;     ///< of beams; a truss has one fibre
  std::vector<double> sizes;  ///< [n_elements] cross-section [length^2], of particles the radius [length]
  Preload preload;            ///< of trusses
};

/// Reads a BEAM, TRUSS or PARTICLE SECTION for a block of lines or particles; sizes that the section leaves
/// out come from the mesh's attributes. Nothing when an error was added: another section or none, a shape or
/// size that is missing or wrong.
///   block  position in the mesh
std::optional<LineSetup> make_line_setup(const SectionDefinition* section, const Mesh& mesh,
                                         std::uint32_t block, const DeckLocation& location,
                                         Diagnostics& diagnostics);

}  // namespace contactsim

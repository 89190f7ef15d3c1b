// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/definition/function.hpp"
#include "core/definition/section.hpp"
#include "core/elements/model_block.hpp"

namespace contactsim {

/// Whether elements of the section are springs, dampers or point masses.
bool is_discrete(const SectionDefinition& section);

/// Where a block of springs, dampers or point masses comes from.
struct DiscreteScope {
  const Mesh& mesh;
  std::uint32_t block;  ///< position in the mesh
  const std::vector<FunctionDefinition>& functions;
  Diagnostics& diagnostics;
};

/// Builds the block. Springs and point masses need no material. A damper resists the rate of its strain with
/// its cross-section times YOUNGS MODULUS of its material, which is a viscosity here. Nothing when an error
/// was added: elements of another shape or without length, a section without mass, stiffness or a function of
/// the strain alone, a function whose steepest slope is not known, an inertia that is no inertia, or one that
/// is not the same about all axes on a free node.
///   material  of the block, if it has one
/// Precondition: the section is discrete.
std::optional<ModelBlock> make_discrete(const SectionDefinition& section,
                                        const std::optional<ElementProperties>& material,
                                        const DiscreteScope& scope);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/static_elements.hpp"

#include "core/elements/element_table.hpp"

namespace contactsim {

namespace {

/// DRILLING STIFFNESS FACTOR where a section gives none: strips bent into circles come out the same from 1e-3
/// to 0.1 (decks/verification/static_rollup.i) [1].
constexpr double drilling_factor = 1e-3;

}  // namespace

void make_static(Model& model) {
  for (ModelBlock& block : model.blocks) {
    ElementProperties& properties = block.properties;
    properties.linear_bulk_viscosity = properties.quadratic_bulk_viscosity = 0.0;
    properties.hourglass_viscosity = 0.0;
    const bool is_shell = !block.thickness.empty() && block.element->has_rotations;
    if (!is_shell || block.shell.drilling > 0.0) continue;
    block.shell.drilling = drilling_factor;
    block.layout.n_own += block.element->n_nodes;
  }
}

}  // namespace contactsim

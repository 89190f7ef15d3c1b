// SPDX-License-Identifier: BSD-3-Clause
#include "core/rigid/rigid_blocks.hpp"

#include "core/base/names.hpp"
#include "core/definition/simulation.hpp"
#include "core/mesh/block_names.hpp"

namespace contactsim {

std::vector<std::uint32_t> find_rigid_blocks(const SimulationDefinition& definition, const Region& region,
                                             const Mesh& mesh, const RigidBodyDefinition& body) {
  std::vector<std::uint32_t> blocks;
  const FiniteElementModel* model = find_finite_element_model(definition, region);
  if (model == nullptr) return blocks;
  const auto names = find_block_names(mesh, model->aliases);
  for (std::uint32_t i = 0; i < mesh.blocks().size(); ++i) {
    const BlockParameters* parameters = find_block_parameters(*model, names[i]);
    const SectionDefinition* section = parameters ? find_section(definition, *parameters) : nullptr;
    const bool is_member =
        section != nullptr && section->rigid_body && fold(section->rigid_body->text) == fold(body.name.text);
    if (is_member) blocks.push_back(i);
  }
  return blocks;
}

}  // namespace contactsim

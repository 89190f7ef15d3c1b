// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/deck_report.hpp"

#include <fmt/format.h>

#include "core/base/pluralize.hpp"
#include "core/definition/simulation.hpp"

namespace contactsim {

std::string format_definition(const SimulationDefinition& definition) {
  return fmt::format(
      "  {}, {}, {}, {}, {} with contact\n", pluralize(definition.materials.size(), "material"),
      pluralize(definition.sections.size(), "section"), pluralize(definition.functions.size(), "function"),
      pluralize(definition.procedures.size(), "procedure"),
      pluralize(regions_with_contact(definition).size(), "region"));
}

std::string format_mesh(const Mesh& mesh) {
  std::string text = fmt::format(
      "  {}, {}, {}, {}, {}, {}\n", pluralize(mesh.n_nodes(), "node"),
      pluralize(mesh.n_elements(), "element"), pluralize(mesh.blocks().size(), "block"),
      pluralize(mesh.side_sets().size(), "side set"), pluralize(mesh.node_sets().size(), "node set"),
      pluralize(mesh.assemblies().size(), "assembly", "assemblies"));
  for (std::uint32_t i = 0; i < mesh.blocks().size(); ++i) {
    const ElementBlock& block = mesh.blocks()[i];
    const std::string type = block.shape == Shape::unknown ? fmt::format("'{}'", block.type_name)
                                                           : std::string(topology(block.shape).name);
    text += fmt::format("  block {:<28} id {:>8} {:>10} elements {}\n", mesh.name({EntityKind::block, i}),
                        block.id, block.n_elements, type);
  }
  return text;
}

}  // namespace contactsim

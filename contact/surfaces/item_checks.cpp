// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/item_checks.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "core/base/errors.hpp"

namespace contactsim {

namespace {

void add_error(Diagnostics& diagnostics, const DeckName& name, std::string text, std::string hint = "") {
  diagnostics.add_error(name.location, std::move(text), std::move(hint), static_cast<int>(name.text.size()));
}

}  // namespace

bool check_not_particles(const Mesh& mesh, const Entity& entity, const DeckName& name,
                         std::string_view command, Diagnostics& diagnostics) {
  if (entity.kind != EntityKind::block) return true;
  if (topology(mesh.blocks()[entity.index].shape).family != Family::particle) return true;
  add_error(diagnostics, name,
            fmt::format("block '{}' holds particles only, which {} cannot take", mesh.name(entity), command),
            "use the line CONTACT SURFACE ... CONTAINS, or CONTACT NODE SET");
  return false;
}

bool check_faces(const Mesh& mesh, std::uint32_t set_index, const DeckName& item, Diagnostics& diagnostics) {
  for (const ElementSide side : mesh.side_sets()[set_index].sides) {
    const Topology& shape = topology(mesh.blocks()[mesh.block_of(side.element())].shape);
    if (shape.sides.empty()) continue;
    const SideKind kind = shape.sides[static_cast<std::size_t>(side.side() - 1)].kind;
    if (kind == SideKind::face) continue;
    add_error(diagnostics, item,
              fmt::format("side set '{}' holds side {} of element {} ({}), which is {} and no contact face",
                          mesh.name({EntityKind::side_set, set_index}), side.side(),
                          mesh.element_id(side.element()), shape.name,
                          kind == SideKind::edge ? "an edge" : "a node"));
    return false;
  }
  return true;
}

void check_shape(const Mesh& mesh, std::uint32_t block_index, const DeckLocation& location) {
  const ElementBlock& block = mesh.blocks()[block_index];
  if (block.shape != Shape::unknown || block.n_elements == 0) return;
  const std::string type = block.type_name.empty()
                               ? "no element type"
                               : fmt::format("element type '{}' with {} nodes per element", block.type_name,
                                             block.nodes_per_element);
  throw FileError(mesh.path(),
                  fmt::format("block {} ({}): {}, which contact at {} cannot use", block.id,
                              mesh.name({EntityKind::block, block_index}), type, to_string(location)));
}

}  // namespace contactsim

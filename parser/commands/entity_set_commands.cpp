// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/entity_set_commands.hpp"

namespace contactsim {

namespace {

void read_ids(Arguments& arguments, std::vector<EntityId>& ids) {
  do {
    const DeckLocation location = arguments.at_end() ? arguments.location() : arguments.peek().location;
    ids.push_back({arguments.positive_integer(), location});
  } while (!arguments.at_end());
}

}  // namespace

std::vector<Row<EntitySet>> entity_set_rows() {
  using E = EntitySet;
  return {
      flag("include all blocks", &E::includes_all_blocks, "Adds every block of the mesh"),
      row("node set", read::names, &E::node_sets, "Adds node sets").or_spelled("nodeset"),
      row("surface", read::names, &E::side_sets, "Adds the nodes or faces of side sets")
          .or_spelled("side set")
          .or_spelled("sideset"),
      row("block", read::names, &E::blocks, "Adds element blocks"),
      row("assembly", read::names, &E::assemblies, "Adds the members of assemblies"),
      row("rigid body", read::names, &E::rigid_bodies, "Adds rigid bodies"),
      row<E>(
          "node", "= <id> ...", [](Arguments& arguments, E& set) { read_ids(arguments, set.nodes); },
          "Adds single nodes by their Exodus ids", "none"),
      row<E>(
          "element", "= <id> ...", [](Arguments& arguments, E& set) { read_ids(arguments, set.elements); },
          "Adds single elements by their Exodus ids", "none"),
      row("remove node set", read::names, &E::removed_node_sets, "Takes node sets away again")
          .or_spelled("remove nodeset"),
      row("remove surface", read::names, &E::removed_side_sets, "Takes side sets away again")
          .or_spelled("remove side set")
          .or_spelled("remove sideset"),
      row("remove block", read::names, &E::removed_blocks, "Takes blocks away again"),
  };
}

}  // namespace contactsim

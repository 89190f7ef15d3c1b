// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/entity_set_commands.hpp"

#include "parser/commands/row_lists.hpp"

namespace contactsim {

namespace {

void read_ids(Arguments& arguments, std::vector<EntityId>& ids) {
  do {
    const DeckLocation location = arguments.at_end() ? arguments.location() : arguments.peek().location;
    ids.push_back({arguments.positive_integer(), location});
  } while (!arguments.at_end());
}

std::vector<Row<EntitySet>> adding_rows() {
  using E = EntitySet;
  using K = NameKind;
  return {
      flag("include all blocks", &E::includes_all_blocks, "Adds every block of the mesh"),
      row("node set", read::names_of(K::node_set), &E::node_sets, "Adds node sets").or_spelled("nodeset"),
      row("surface", read::names_of(K::side_set), &E::side_sets, "Adds the nodes or faces of side sets")
          .or_spelled("side set")
          .or_spelled("sideset"),
      row("block", read::names_of(K::block), &E::blocks, "Adds element blocks"),
      row("assembly", read::names_of(K::assembly), &E::assemblies, "Adds the members of assemblies"),
      row("rigid body", read::names_of(K::rigid_body), &E::rigid_bodies, "Adds rigid bodies"),
      row<E>(
          "node", "= <id> ...", [](Arguments& arguments, E& set) { read_ids(arguments, set.nodes); },
          "Adds single nodes by their Exodus ids", "none"),
      row<E>(
          "element", "= <id> ...", [](Arguments& arguments, E& set) { read_ids(arguments, set.elements); },
          "Adds single elements by their Exodus ids", "none"),
  };
}

std::vector<Row<EntitySet>> removing_rows() {
  using E = EntitySet;
  using K = NameKind;
  return {
      row("remove node set", read::names_of(K::node_set), &E::removed_node_sets, "Takes node sets away again")
          .or_spelled("remove nodeset"),
      row("remove surface", read::names_of(K::side_set), &E::removed_side_sets, "Takes side sets away again")
          .or_spelled("remove side set")
          .or_spelled("remove sideset"),
      row("remove block", read::names_of(K::block), &E::removed_blocks, "Takes blocks away again"),
  };
}

}  // namespace

std::vector<Row<EntitySet>> entity_set_rows(const Choice& choice) {
  return joined<EntitySet>({one_of(choice, adding_rows()), removing_rows()});
}

}  // namespace contactsim

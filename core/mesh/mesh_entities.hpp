// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/indices.hpp"
#include "core/mesh/entity_names.hpp"
#include "core/mesh/topology.hpp"

namespace contactsim {

/// One element block, as the mesh file holds it.
struct ElementBlock {
  std::int64_t id = 0;
  std::string name;       ///< as stored, "" when the file has none; see Mesh::name
  std::string type_name;  ///< the file's elem_type, "" when missing
  Shape shape = Shape::unknown;
  ElementIndex first_element;
  std::uint32_t n_elements = 0;
  int nodes_per_element = 0;
  std::vector<NodeIndex>
      nodes;  ///< n_elements x nodes_per_element, element by element; empty for unknown shapes
  bool has_repeated_nodes = false;           ///< some element names a node twice (degenerate)
  std::vector<std::string> attribute_names;  ///< n_attributes; "" where the file has no name
  std::vector<double> attributes;            ///< n_elements x n_attributes, element by element

  std::span<const NodeIndex> element_nodes(std::uint32_t element_in_block) const {
    const auto n = static_cast<std::size_t>(nodes_per_element);
    return {nodes.data() + element_in_block * n, n};
  }
};

/// A list of element sides. Sides may repeat, overlap other sets and lie inside the mesh.
struct SideSet {
  std::int64_t id = 0;
  std::string name;
  std::vector<ElementSide> sides;
  std::vector<double> distribution_factors;  ///< passed through to results; may be empty
};

struct NodeSet {
  std::int64_t id = 0;
  std::string name;
  std::vector<NodeIndex> nodes;
  std::vector<double> distribution_factors;  ///< passed through to results; may be empty
};

/// A named list of entities of one kind; nested assemblies are resolved by Mesh::members.
struct Assembly {
  std::int64_t id = 0;
  std::string name;
  std::optional<EntityKind>
      member_kind;                     ///< absent: a kind that contactsim does not use (edge set, blob, ...)
  std::vector<std::uint32_t> members;  ///< positions in the mesh's list of that kind
};

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/meshes/mesh_invariants.hpp"

#include <cmath>
#include <set>

#include "core/base/names.hpp"

namespace contactsim::test {

namespace {

template <class Items>
std::string find_twice(const Items& items, const Mesh& mesh, EntityKind kind) {
  std::set<std::int64_t> ids;
  std::set<std::string> names;
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    if (!ids.insert(items[i].id).second) return "an id stands twice";
    const std::string name = mesh.name({kind, i});
    if (!names.insert(fold(name)).second) return "a name stands twice: " + name;
    if (mesh.find(kind, name) != i) return "a name is not found: " + name;
    for (const char c : items[i].name) {
      if ((c >= 0 && c < 0x20) || c == 0x7f) return "a name has a control character";
    }
  }
  return "";
}

std::string find_in(const ElementBlock& block, std::uint32_t first, std::uint32_t n_nodes) {
  if (block.first_element.value != first) return "a block does not begin where the one before it ends";
  const bool is_known = block.shape != Shape::unknown && block.shape != Shape::null;
  const std::size_t n = is_known ? std::size_t{block.n_elements} * topology(block.shape).n_nodes : 0;
  if (is_known && block.nodes_per_element != topology(block.shape).n_nodes) return "a shape has other nodes";
  if (block.nodes.size() != n) return "a block has not the nodes of its elements";
  bool has_repeats = false;
  for (const NodeIndex node : block.nodes) {
    if (node.value >= n_nodes) return "an element has a node that is not there";
  }
  for (std::uint32_t e = 0; is_known && e < block.n_elements; ++e) {
    const auto nodes = block.element_nodes(e);
    has_repeats = has_repeats || std::set<NodeIndex>(nodes.begin(), nodes.end()).size() < nodes.size();
  }
  if (has_repeats != block.has_repeated_nodes) return "repeated nodes are not noted, or where there are none";
  if (block.attributes.size() != block.attribute_names.size() * block.n_elements)
    return "a block has not the attributes of its elements";
  return "";
}

std::string find_in(const SideSet& set, const Mesh& mesh) {
  for (const ElementSide side : set.sides) {
    if (side.element().value >= mesh.n_elements()) return "a side set has an element that is not there";
    const Shape shape = mesh.blocks()[mesh.block_of(side.element())].shape;
    const int n_sides = shape == Shape::unknown ? 8 : static_cast<int>(topology(shape).sides.size());
    if (side.side() < 1 || side.side() > n_sides) return "a side set has a side that is not there";
  }
  return "";
}

std::string find_in(const NodeSet& set, const Mesh& mesh) {
  for (const NodeIndex node : set.nodes) {
    if (node.value >= mesh.n_nodes()) return "a node set has a node that is not there";
  }
  if (!set.distribution_factors.empty() && set.distribution_factors.size() != set.nodes.size())
    return "a node set has not the factors of its nodes";
  return "";
}

std::string find_in(const Assembly& assembly, const Mesh& mesh) {
  if (!assembly.member_kind) return "";
  const std::size_t sizes[] = {mesh.blocks().size(), mesh.side_sets().size(), mesh.node_sets().size(),
                               mesh.assemblies().size()};
  for (const std::uint32_t member : assembly.members) {
    if (member >= sizes[static_cast<std::size_t>(*assembly.member_kind)])
      return "an assembly has a member that is not there";
  }
  return "";
}

std::string find_in_ids(const Mesh& mesh) {
  for (std::uint32_t n = 0; n < mesh.n_nodes(); ++n) {
    const auto found = mesh.find_node(mesh.node_id({n}));
    if (!found || found->value > n || mesh.node_id(*found) != mesh.node_id({n}))
      return "a node id is not found";
  }
  for (std::uint32_t e = 0; e < mesh.n_elements(); ++e) {
    const auto found = mesh.find_element(mesh.element_id({e}));
    if (!found || found->value > e) return "an element id is not found";
  }
  return "";
}

std::string find_in_lists(const Mesh& mesh) {
  for (const SideSet& set : mesh.side_sets()) {
    if (std::string broken = find_in(set, mesh); !broken.empty()) return broken;
  }
  for (const NodeSet& set : mesh.node_sets()) {
    if (std::string broken = find_in(set, mesh); !broken.empty()) return broken;
  }
  for (const Assembly& assembly : mesh.assemblies()) {
    if (std::string broken = find_in(assembly, mesh); !broken.empty()) return broken;
  }
  return find_in_ids(mesh);
}

}  // namespace

std::string find_broken_reference(const Mesh& mesh) {
  for (std::uint32_t n = 0; n < mesh.n_nodes(); ++n) {
    if (!mesh.coordinates().col(n).allFinite()) return "a coordinate is no number";
  }
  std::uint32_t n_elements = 0;
  for (const ElementBlock& block : mesh.blocks()) {
    if (std::string broken = find_in(block, n_elements, mesh.n_nodes()); !broken.empty()) return broken;
    n_elements += block.n_elements;
  }
  if (n_elements != mesh.n_elements()) return "the blocks have not the elements of the mesh";
  std::string broken = find_twice(mesh.blocks(), mesh, EntityKind::block);
  if (broken.empty()) broken = find_twice(mesh.side_sets(), mesh, EntityKind::side_set);
  if (broken.empty()) broken = find_twice(mesh.node_sets(), mesh, EntityKind::node_set);
  if (broken.empty()) broken = find_twice(mesh.assemblies(), mesh, EntityKind::assembly);
  return broken.empty() ? find_in_lists(mesh) : broken;
}

}  // namespace contactsim::test

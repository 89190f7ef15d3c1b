// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/results_format.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "io/exodus/results_mesh.hpp"

namespace contactsim {

namespace {

void add_size(std::size_t n_values, std::size_t bytes_per_value, ResultsSizes& sizes) {
  sizes.n_variable_bytes = std::max(sizes.n_variable_bytes, n_values * bytes_per_value);
}

void add_name(std::size_t length, ResultsSizes& sizes) {
  sizes.longest_name = std::max(sizes.longest_name, length);
}

void add_map(const std::vector<std::int64_t>& ids, ResultsSizes& sizes) {
  if (ids.empty()) return;
  sizes.largest_id = std::max(sizes.largest_id, *std::max_element(ids.begin(), ids.end()));
  add_size(ids.size(), sizeof(std::int64_t), sizes);
}

// The ids and names of one kind; fields are no larger than the nodes or elements that they are given for.
template <class Items>
void add_entities(const Mesh& mesh, EntityKind kind, const Items& items, ResultsSizes& sizes) {
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    sizes.largest_id = std::max(sizes.largest_id, items[i].id);
    add_name(mesh.name({kind, i}).size(), sizes);
  }
}

}  // namespace

ResultsSizes find_results_sizes(const Mesh& mesh, std::span<const OutputField> fields) {
  ResultsSizes sizes;
  add_size(mesh.n_nodes(), sizeof(double), sizes);
  add_map(make_node_map(mesh), sizes);
  add_map(make_element_map(mesh), sizes);
  for (const ElementBlock& block : mesh.blocks()) {
    add_size(block.n_elements, sizeof(double), sizes);
    add_size(block.nodes.size(), sizeof(std::int32_t), sizes);
    add_size(block.attributes.size(), sizeof(double), sizes);
    for (const std::string& name : block.attribute_names) add_name(name.size(), sizes);
  }
  for (const SideSet& set : mesh.side_sets()) {
    add_size(set.sides.size(), sizeof(std::int32_t), sizes);
    add_size(set.distribution_factors.size(), sizeof(double), sizes);
  }
  for (const NodeSet& set : mesh.node_sets()) add_size(set.nodes.size(), sizeof(double), sizes);
  add_entities(mesh, EntityKind::block, mesh.blocks(), sizes);
  add_entities(mesh, EntityKind::side_set, mesh.side_sets(), sizes);
  add_entities(mesh, EntityKind::node_set, mesh.node_sets(), sizes);
  add_entities(mesh, EntityKind::assembly, mesh.assemblies(), sizes);
  for (const OutputField& field : fields) {
    for (int c = 0; c < field.n_components; ++c) {
      add_name(component_name(field, c).size(), sizes);
    }
  }
  return sizes;
}

ExodusFormat choose_format(const ResultsSizes& sizes) {
  ExodusFormat format;
  format.has_wide_ids = sizes.largest_id > std::numeric_limits<std::int32_t>::max();
  format.is_large = format.has_wide_ids || sizes.n_variable_bytes > NetcdfOutput::largest_plain_variable;
  // Readers take a length of 32 for granted.
  format.name_length = std::max<std::size_t>(32, sizes.longest_name);
  return format;
}

}  // namespace contactsim

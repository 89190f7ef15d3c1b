// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_blocks.hpp"

#include <fmt/format.h>

#include "io/exodus/exodus_attributes.hpp"
#include "io/exodus/exodus_entities.hpp"
#include "io/exodus/index_arrays.hpp"

namespace contactsim {

namespace {

class BlockReader {
 public:
  BlockReader(const ExodusFile& file, const EntityRow& row, std::uint32_t n_nodes)
      : file_(file), row_(row), suffix_(fmt::to_string(row.number)), n_nodes_(n_nodes) {}

  ElementBlock read();

 private:
  [[noreturn]] void fail(const std::string& what) const {
    file_.fail(fmt::format("{}: {}", describe(EntityKind::block, row_.id, row_.name), what));
  }
  std::size_t count_elements() const;
  void read_connectivity(ElementBlock& block) const;
  void read_nodes(const NetcdfVariable& connectivity, ElementBlock& block) const;
  void read_attributes(ElementBlock& block) const;

  const ExodusFile& file_;
  const EntityRow& row_;
  std::string suffix_;
  std::uint32_t n_nodes_;
};

ElementBlock BlockReader::read() {
  ElementBlock block;
  block.id = row_.id;
  block.name = row_.name;
  const std::size_t n_elements = row_.is_null ? 0 : count_elements();
  if (n_elements > max_elements) fail(fmt::format("{} elements are more than {}", n_elements, max_elements));
  block.n_elements = static_cast<std::uint32_t>(n_elements);
  read_connectivity(block);
  read_attributes(block);
  return block;
}

std::size_t BlockReader::count_elements() const {
  const std::size_t declared = file_.dimension("num_el_in_blk" + suffix_);
  const auto connectivity = file_.find_variable("connect" + suffix_);
  if (!connectivity || connectivity->shape.size() != 2) return declared;
  if (declared != connectivity->shape[0]) {
    fail(fmt::format("declares {} elements, its connectivity has {}", declared, connectivity->shape[0]));
  }
  return declared;
}

void BlockReader::read_connectivity(ElementBlock& block) const {
  const auto connectivity = file_.find_variable("connect" + suffix_);
  if (connectivity) block.type_name = file_.find_text(*connectivity, "elem_type").value_or("");
  const bool is_rectangular = connectivity && connectivity->shape.size() == 2;
  if (is_rectangular && connectivity->shape[1] <= 1000) {
    block.nodes_per_element = static_cast<int>(connectivity->shape[1]);
    block.shape = find_shape(block.type_name, block.nodes_per_element);
  }
  if (block.n_elements == 0) {
    if (block.shape == Shape::unknown) block.shape = Shape::null;
    return;
  }
  if (block.shape == Shape::null) block.shape = Shape::unknown;
  // Polyhedra list their faces in a variable of their own.
  if (!connectivity && !file_.find_variable("facconn" + suffix_)) {
    fail(fmt::format("has {} elements but no connectivity (variable connect{})", block.n_elements, suffix_));
  }
  if (block.shape != Shape::unknown) read_nodes(*connectivity, block);
}

void BlockReader::read_nodes(const NetcdfVariable& connectivity, ElementBlock& block) const {
  const auto columns = static_cast<std::size_t>(block.nodes_per_element);
  const IndexArray found = read_positions(file_, connectivity, n_nodes_, block.nodes);
  block.has_repeated_nodes = found.has_repeats;
  if (!found.bad) return;
  fail(fmt::format("element {} of the block: node {} of {} is {}, but the mesh has nodes 1 to {}",
                   found.bad->position / columns + 1, found.bad->position % columns + 1, columns,
                   found.bad->value, n_nodes_));
}

void BlockReader::read_attributes(ElementBlock& block) const {
  const auto values = file_.find_variable("attrib" + suffix_);
  if (!values || block.n_elements == 0) return;
  if (values->shape.size() != 2 || values->shape[0] != block.n_elements) {
    fail(fmt::format("its attributes (variable {}) do not match its {} elements", values->name,
                     block.n_elements));
  }
  const std::size_t n_attributes = values->shape[1];
  block.attribute_names = default_attribute_names(block, n_attributes);
  if (const auto names = file_.find_variable("attrib_name" + suffix_)) {
    const std::vector<std::string> stored = file_.read_texts(*names);
    if (stored.size() != n_attributes) {
      fail(fmt::format("has {} attributes but {} names for them", n_attributes, stored.size()));
    }
    for (std::size_t i = 0; i < n_attributes; ++i) {
      if (!stored[i].empty()) block.attribute_names[i] = stored[i];
    }
  }
  block.attributes.resize(values->size());
  file_.read_double(*values, block.attributes);
}

}  // namespace

std::vector<ElementBlock> read_blocks(const ExodusFile& file, std::uint32_t n_nodes, Diagnostics& warnings) {
  const std::size_t n_elements = file.dimension("num_elem");
  if (n_elements > max_elements) {
    file.fail(fmt::format("has {} elements; at most {} are possible", n_elements, max_elements));
  }
  std::vector<ElementBlock> blocks;
  std::size_t sum = 0;
  for (const EntityRow& row : read_entity_rows(file, EntityKind::block, warnings)) {
    blocks.push_back(BlockReader(file, row, n_nodes).read());
    sum += blocks.back().n_elements;
  }
  if (sum != n_elements) {
    file.fail(fmt::format("its blocks have {} elements, but num_elem says {}", sum, n_elements));
  }
  return blocks;
}

}  // namespace contactsim

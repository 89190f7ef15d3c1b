// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_variables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "io/exodus/exodus_entities.hpp"
#include "io/exodus/file_order.hpp"
#include "io/pieces/exodus_file.hpp"

namespace contactsim {

namespace {

/// A block of the mesh and the number by which its variables are named.
struct StoredBlock {
  std::size_t number = 0;  ///< from 1
  std::size_t first_element = 0, n_elements = 0;
  FileOrder order;
};

/// An open file of results.
class ResultsFile {
 public:
  ResultsFile(const std::string& path, const Mesh& mesh)
      : file_(path),
        n_nodes_(mesh.n_nodes()),
        n_elements_(mesh.n_elements()),
        node_order_(FileOrder::of_nodes(mesh)) {
    find_blocks(mesh);
    read_times();
  }

  const std::vector<double>& times() const { return times_; }
  std::vector<std::string> names(const std::string& list) const;
  std::vector<double> read_nodal(std::size_t variable, std::size_t time) const;
  std::vector<double> read_element(std::size_t variable, std::size_t time) const;

 private:
  void find_blocks(const Mesh& mesh);
  void read_times();
  void check_shape(const NetcdfVariable& variable, const std::vector<std::size_t>& shape) const;

  ExodusFile file_;
  std::size_t n_nodes_, n_elements_;
  FileOrder node_order_;
  std::vector<StoredBlock> blocks_;
  std::vector<double> times_;
};

/// Files number their blocks in the order of their ids' list, empty ones too.
void ResultsFile::find_blocks(const Mesh& mesh) {
  Diagnostics seen_by_the_mesh_reader;
  for (const EntityRow& row : read_entity_rows(file_, EntityKind::block, seen_by_the_mesh_reader)) {
    const auto block = std::find_if(mesh.blocks().begin(), mesh.blocks().end(),
                                    [&](const ElementBlock& one) { return one.id == row.id; });
    if (block == mesh.blocks().end()) continue;
    blocks_.push_back(
        {row.number, block->first_element.value, block->n_elements, FileOrder::of_block(mesh, *block)});
  }
}

void ResultsFile::read_times() {
  const auto variable = file_.find_variable("time_whole");
  if (!variable) return;
  if (variable->shape.size() != 1) file_.fail("variable time_whole is not a list of times");
  times_.resize(variable->size());
  file_.read_double(*variable, times_);
  const auto rises = [](double a, double b) { return !(a < b); };
  if (std::adjacent_find(times_.begin(), times_.end(), rises) != times_.end())
    file_.fail("its stored times do not rise");
}

std::vector<std::string> ResultsFile::names(const std::string& list) const {
  const auto variable = file_.find_variable(list);
  return variable ? file_.read_texts(*variable) : std::vector<std::string>{};
}

void ResultsFile::check_shape(const NetcdfVariable& variable, const std::vector<std::size_t>& shape) const {
  if (variable.shape == shape && !variable.is_text) return;
  file_.fail(
      fmt::format("variable {} does not match the mesh and its {} times", variable.name, times_.size()));
}

/// Either layout: a variable of its own, or a part of one that holds all.
std::vector<double> ResultsFile::read_nodal(std::size_t variable, std::size_t time) const {
  std::vector<double> values(n_nodes_);
  const std::string name = fmt::format("vals_nod_var{}", variable + 1);
  if (const auto own = file_.find_variable(name)) {
    check_shape(*own, {times_.size(), n_nodes_});
    file_.read_double(*own, {time, 1}, values);
    node_order_.to_mesh(values);
    return values;
  }
  const auto all = file_.find_variable("vals_nod_var");
  if (!all) file_.fail(fmt::format("has no variable {}", name));
  const std::size_t n_variables = file_.dimension("num_nod_var");
  check_shape(*all, {times_.size(), n_variables, n_nodes_});
  std::vector<double> row(n_variables * n_nodes_);
  file_.read_double(*all, {time, 1}, row);
  std::copy_n(row.begin() + static_cast<std::ptrdiff_t>(variable * n_nodes_), n_nodes_, values.begin());
  node_order_.to_mesh(values);
  return values;
}

std::vector<double> ResultsFile::read_element(std::size_t variable, std::size_t time) const {
  std::vector<double> values(n_elements_, std::numeric_limits<double>::quiet_NaN());
  for (const StoredBlock& block : blocks_) {
    const auto stored = file_.find_variable(fmt::format("vals_elem_var{}eb{}", variable + 1, block.number));
    if (!stored) continue;
    check_shape(*stored, {times_.size(), block.n_elements});
    const auto of_block = std::span(values).subspan(block.first_element, block.n_elements);
    file_.read_double(*stored, {time, 1}, of_block);
    block.order.to_mesh(of_block);
  }
  return values;
}

}  // namespace

StoredVariables read_stored_variables(const std::string& path, const Mesh& mesh) {
  const auto file = std::make_shared<const ResultsFile>(path, mesh);
  StoredVariables stored;
  stored.times = file->times();
  stored.nodal.names = file->names("name_nod_var");
  stored.nodal.read = [file](std::size_t variable, std::size_t time) {
    return file->read_nodal(variable, time);
  };
  stored.element.names = file->names("name_elem_var");
  stored.element.read = [file](std::size_t variable, std::size_t time) {
    return file->read_element(variable, time);
  };
  return stored;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/results_variables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace contactsim {

namespace {

std::size_t count_entities(const Mesh& mesh, const OutputField& field) {
  if (field.location == FieldLocation::node) return mesh.n_nodes();
  if (field.location == FieldLocation::global) return 1;
  assert(field.block < mesh.blocks().size());
  return mesh.blocks()[field.block].n_elements;
}

}  // namespace

ResultsVariables::ResultsVariables(const Mesh& mesh, std::span<const OutputField> fields, ExodusDraft& draft)
    : node_order_(FileOrder::of_nodes(mesh)) {
  for (const ElementBlock& block : mesh.blocks()) block_orders_.push_back(FileOrder::of_block(mesh, block));
  for (const OutputField& field : fields) fields_.push_back({field, count_entities(mesh, field), 0, {}});
  steps_ = draft.add_dimension("time_step", NetcdfOutput::unlimited);
  draft.file().define_variable("time_whole", NetcdfType::float64, {steps_});
  add_globals(draft);
  if (mesh.n_nodes() > 0) add_nodal(draft);
  add_element(mesh, draft);
}

void ResultsVariables::take_piece(const MeshPiece& piece) {
  for (DefinedField& defined : fields_) {
    if (defined.field.location == FieldLocation::global) continue;
    defined.n_entities = piece.entities(defined.field).size();
    // Pieces have no variables of blocks that they have nothing of.
    if (defined.n_entities == 0) defined.variables.clear();
  }
  node_order_ = {};
  std::ranges::fill(block_orders_, FileOrder());
}

const FileOrder& ResultsVariables::order_of(const OutputField& field) const {
  return field.location == FieldLocation::node ? node_order_ : block_orders_[field.block];
}

// Each once, in the order of first mention.
std::vector<std::string> ResultsVariables::component_names(FieldLocation location) const {
  std::vector<std::string> names;
  for (const auto& [field, n_entities, first_global, variables] : fields_) {
    if (field.location != location) continue;
    for (int c = 0; c < field.n_components; ++c) {
      const std::string name = component_name(field, c);
      const bool is_new = std::find(names.begin(), names.end(), name) == names.end();
      assert(is_new || location == FieldLocation::element);
      if (is_new) names.push_back(name);
    }
  }
  return names;
}

void ResultsVariables::add_globals(ExodusDraft& draft) {
  const std::vector<std::string> names = component_names(FieldLocation::global);
  if (names.empty()) return;
  std::size_t n_before = 0;
  for (DefinedField& defined : fields_) {
    if (defined.field.location != FieldLocation::global) continue;
    defined.first_global = n_before;
    n_before += static_cast<std::size_t>(defined.field.n_components);
  }
  const int n_names = draft.add_dimension("num_glo_var", names.size());
  draft.add_texts("name_glo_var", {n_names}, "len_name", names);
  draft.file().define_variable("vals_glo_var", NetcdfType::float64, {steps_, n_names});
}

void ResultsVariables::add_nodal(ExodusDraft& draft) {
  const std::vector<std::string> names = component_names(FieldLocation::node);
  if (names.empty()) return;
  const int n_names = draft.add_dimension("num_nod_var", names.size());
  draft.add_texts("name_nod_var", {n_names}, "len_name", names);
  const int n_nodes = draft.dimension("num_nodes");
  int number = 0;
  for (DefinedField& defined : fields_) {
    if (defined.field.location != FieldLocation::node) continue;
    for (int c = 0; c < defined.field.n_components; ++c) {
      defined.variables.push_back(fmt::format("vals_nod_var{}", ++number));
      draft.file().define_variable(defined.variables.back(), NetcdfType::float64, {steps_, n_nodes});
    }
  }
}

void ResultsVariables::add_element(const Mesh& mesh, ExodusDraft& draft) {
  const std::vector<std::string> names = component_names(FieldLocation::element);
  if (names.empty()) return;
  const int n_names = draft.add_dimension("num_elem_var", names.size());
  draft.add_texts("name_elem_var", {n_names}, "len_name", names);
  std::vector<std::int32_t> table(mesh.blocks().size() * names.size(), 0);
  for (DefinedField& defined : fields_) {
    const OutputField& field = defined.field;
    if (field.location != FieldLocation::element || defined.n_entities == 0) continue;
    const int n_elements = draft.dimension(fmt::format("num_el_in_blk{}", field.block + 1));
    for (int c = 0; c < field.n_components; ++c) {
      const auto name = std::find(names.begin(), names.end(), component_name(field, c));
      const auto position = static_cast<std::size_t>(name - names.begin());
      defined.variables.push_back(fmt::format("vals_elem_var{}eb{}", position + 1, field.block + 1));
      draft.file().define_variable(defined.variables.back(), NetcdfType::float64, {steps_, n_elements});
      table[field.block * names.size() + position] = 1;
    }
  }
  draft.add_integers("elem_var_tab", {draft.dimension("num_el_blk"), n_names}, [table] { return table; });
}

void ResultsVariables::write(std::size_t field, std::span<const double> values, RecordFile& file) const {
  const DefinedField& defined = fields_.at(field);
  const auto n_components = static_cast<std::size_t>(defined.field.n_components);
  if (values.size() != defined.n_entities * n_components) {
    throw std::logic_error(fmt::format("result field {} with {} values where {} were defined",
                                       defined.field.name, values.size(), defined.n_entities * n_components));
  }
  if (defined.field.location == FieldLocation::global)
    file.write("vals_glo_var", values, {}, defined.first_global);
  for (std::size_t c = 0; c < defined.variables.size(); ++c) {
    const FileOrder& order = order_of(defined.field);
    if (order.is_same()) {
      file.write(defined.variables[c], values, {c, n_components});
    } else {
      file.write(defined.variables[c], order.to_file(values, n_components, c, 1));
    }
  }
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/output_variables.hpp"

#include <algorithm>

#include "core/output/rigid_output.hpp"
#include "core/output/strain_measures.hpp"

namespace contactsim {

namespace {

FieldShape shape_of(const StateVariable& variable) {
  if (variable.n_components == 1) return FieldShape::scalar;
  return variable.n_components == 6 ? FieldShape::symmetric_tensor : FieldShape::list;
}

// Fills from the state of the materials. Each block's law keeps the variable at a place of its own.
OutputVariable::Fill fill_from_materials(std::vector<std::size_t> first_places, std::size_t n_components) {
  return [first_places = std::move(first_places), n_components](
             const OutputContext& context, const EntityRange& range, std::span<double> values) {
    for (std::size_t i = 0; i < range.count; ++i) {
      const std::size_t place = first_places[range.block];
      if (n_components == 6) {
        const auto tensor = components_of_symmetric(material_tensor(context, range, i, place));
        std::copy(tensor.begin(), tensor.end(), values.begin() + static_cast<std::ptrdiff_t>(6 * i));
        continue;
      }
      for (std::size_t c = 0; c < n_components; ++c)
        values[i * n_components + c] = material_value(context, range, i, place + c);
    }
  };
}

}  // namespace

std::string_view dimension_of(std::string_view help) {
  const std::size_t begin = help.rfind('[');
  return help.ends_with(']') ? help.substr(begin) : std::string_view();
}

OutputVariables::OutputVariables(const Model& model, std::vector<OutputVariable> more,
                                 OutputNames other_names)
    : model_(model), other_names_(other_names) {
  add_rows(global_output_rows());
  add_rows(nodal_output_rows());
  add_rows(element_output_rows());
  for (std::size_t block = 0; block < model.blocks.size(); ++block) add_material_variables(block);
  for (OutputVariable& variable : rigid_variables(model)) add(std::move(variable));
  for (OutputVariable& variable : more) add(std::move(variable));
}

void OutputVariables::add_rows(std::span<const OutputRow> rows) {
  for (const OutputRow& row : rows) {
    OutputVariable variable{
        std::string(row.name), row.location,     row.shape, row.n_components(),
        row.is_at_points,      /*in_blocks*/ {}, row.fill,  std::string(dimension_of(row.help)),
        row.reads_all};
    if (row.location == FieldLocation::element) {
      for (const ModelBlock& block : model_.blocks) {
        const bool has_it = (!row.is_of_shells || !block.thickness.empty()) &&
                            (!row.is_of_cohesive || !block.cohesive.area.empty());
        variable.in_blocks.push_back(has_it ? 1 : 0);
      }
    }
    const bool is_of_some = row.is_of_shells || row.is_of_cohesive;
    if (is_of_some && std::ranges::count(variable.in_blocks, 1) == 0) continue;
    add(std::move(variable));
  }
}

// Blocks whose materials remember the same thing share a variable, made for the first of them.
void OutputVariables::add_material_variables(std::size_t block) {
  for (const StateVariable& own : model_.blocks[block].properties.law.kind().variables) {
    if (find(FieldLocation::element, own.name) != nullptr) continue;
    OutputVariable variable{std::string(own.name),
                            FieldLocation::element,
                            shape_of(own),
                            static_cast<int>(own.n_components),
                            true,
                            std::vector<std::uint8_t>(model_.blocks.size(), 0),
                            {}};
    std::vector<std::size_t> first_places(model_.blocks.size(), 0);
    for (std::size_t b = block; b < model_.blocks.size(); ++b) {
      for (const StateVariable& other : model_.blocks[b].properties.law.kind().variables) {
        if (other.name != own.name || other.n_components != own.n_components) continue;
        variable.in_blocks[b] = 1;
        first_places[b] = other.first;
      }
    }
    variable.fill = fill_from_materials(std::move(first_places), own.n_components);
    variable.dimension = dimension_of(own.help);
    add(std::move(variable));
  }
}

const OutputVariable& OutputVariables::add(OutputVariable variable) {
  variables_.push_back(std::move(variable));
  return variables_.back();
}

const OutputVariable* OutputVariables::find(FieldLocation location, std::string_view name) const {
  const auto found = std::find_if(
      variables_.rbegin(), variables_.rend(),
      [&](const OutputVariable& variable) { return variable.location == location && variable.name == name; });
  return found == variables_.rend() ? nullptr : &*found;
}

std::vector<std::string> OutputVariables::names(FieldLocation location) const {
  std::vector<std::string> names;
  for (const OutputVariable& variable : variables_) {
    if (variable.location == location) names.push_back(variable.name);
  }
  return names;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/stored_variable.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

std::vector<std::size_t> count_entities(const Model& model, FieldLocation location) {
  if (location == FieldLocation::global) return {1};
  if (location == FieldLocation::node) return {model.mesh->n_nodes()};
  std::vector<std::size_t> counts;
  for (const ModelBlock& block : model.blocks) counts.push_back(block.n_elements);
  return counts;
}

}  // namespace

StoredValues::StoredValues(const Model& model, FieldLocation location, std::vector<double> initial)
    : n_components_(initial.size()) {
  for (const std::size_t n : count_entities(model, location)) {
    std::vector<double>& values = values_.emplace_back(n * n_components_);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = initial[i % n_components_];
  }
}

std::span<double> StoredValues::at(const EntityRange& range) {
  return std::span(values_[range.block]).subspan(range.first * n_components_, range.count * n_components_);
}

std::span<const double> StoredValues::at(const EntityRange& range) const {
  return std::span(values_[range.block]).subspan(range.first * n_components_, range.count * n_components_);
}

void StoredValues::archive(const std::string& name, StateArchive& saved) {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const std::string part = fmt::format("{}/{}", name, i + 1);
    if (saved.has(part)) saved.fixed(part, std::span(values_[i]));
  }
}

const OutputVariable& add_stored_variable(OutputVariables& variables, OutputVariable variable,
                                          std::shared_ptr<const StoredValues> values) {
  variable.n_components = static_cast<int>(values->n_components());
  if (variable.location == FieldLocation::element && variable.in_blocks.empty())
    variable.in_blocks.assign(variables.model().blocks.size(), 1);
  variable.fill = [values = std::move(values)](const OutputContext&, const EntityRange& range,
                                               std::span<double> to) {
    const std::span<const double> from = values->at(range);
    std::copy(from.begin(), from.end(), to.begin());
  };
  return variables.add(std::move(variable));
}

}  // namespace contactsim

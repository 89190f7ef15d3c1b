// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/stored_names.hpp"

#include "core/base/names.hpp"
#include "core/definition/output.hpp"
#include "core/definition/region.hpp"

namespace contactsim {

StoredNames::StoredNames(const Region& region) {
  for (const ResultsOutput& output : region.results_outputs) {
    for (const VariableRequest& request : output.variables)
      variables_.try_emplace(fold(output_name(request)), canonical_variable_name(request.variable.name.text));
  }
}

std::string StoredNames::variable_of(const std::string& on_file) const {
  const auto found = variables_.find(fold(on_file));
  return found == variables_.end() ? on_file : found->second;
}

std::vector<std::string> StoredNames::on_file(std::string_view variable) const {
  std::vector<std::string> names;
  for (const auto& [name, of] : variables_) {
    if (of == variable) names.push_back(name);
  }
  names.emplace_back(variable);
  return names;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/output_groups.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/output/output_variables.hpp"
#include "core/output/variable_selection.hpp"

namespace contactsim {

namespace {

/// The group that a request means; null when it means a variable, or nothing.
const OutputGroup* find_group(const OutputVariables& variables, const VariableRequest& request) {
  const std::string name = canonical_variable_name(request.variable.name.text);
  const auto wanted = to_field_location(request.location);
  for (const OutputGroup& group : variables.other_names().groups) {
    const bool is_there = wanted ? *wanted == group.location : request.location == VariableLocation::any;
    if (group.name == name && is_there && variables.find(group.location, name) == nullptr) return &group;
  }
  return nullptr;
}

}  // namespace

std::vector<VariableRequest> expand_groups(const OutputVariables& variables,
                                           std::span<const VariableRequest> requests,
                                           Diagnostics& diagnostics) {
  std::vector<VariableRequest> expanded;
  for (const VariableRequest& request : requests) {
    const OutputGroup* group = find_group(variables, request);
    if (group == nullptr) {
      expanded.push_back(request);
      continue;
    }
    const VariableReference& asked = request.variable;
    if (!request.alias.empty() || !asked.component.empty()) {
      diagnostics.add_warning(
          "output-group", asked.name.location,
          fmt::format("{} stands for {} variables, which keep their names and all components",
                      asked.name.text, group->members.size()),
          "ask for one of them to rename it", static_cast<int>(asked.name.text.size()));
    }
    for (const std::string_view member : group->members) {
      VariableRequest one = request;
      one.variable.name.text = member;
      one.variable.component.clear();
      one.alias.clear();
      expanded.push_back(std::move(one));
    }
  }
  return expanded;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/stored_values.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace contactsim {

namespace {

std::vector<double> read_at(const StoredVariableKind& kind, std::size_t variable, const StoredTime& time) {
  std::vector<double> values = kind.read(variable, time.first);
  if (time.weight == 0.0) return values;
  const std::vector<double> after = kind.read(variable, time.second);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = (1.0 - time.weight) * values[i] + time.weight * after[i];
  return values;
}

}  // namespace

StoredTime StoredReader::time_of(const MeshVariable& variable) const {
  const std::size_t last = stored_.times.size() - 1;
  switch (variable.time) {
    case MeshVariable::Time::first:
      return {0, 0, 0.0};
    case MeshVariable::Time::last:
      return {last, last, 0.0};
    case MeshVariable::Time::given:
      return find_stored_time(stored_.times, variable.given_time);
    case MeshVariable::Time::run_time:
      break;
  }
  return find_stored_time(stored_.times, start_);
}

std::optional<StoredValues> StoredReader::read(const MeshVariable& variable, bool is_element,
                                               std::size_t n_components) const {
  const DeckName& name = *variable.variable;
  const StoredVariableKind& kind = is_element ? stored_.element : stored_.nodal;
  const char* what = is_element ? "element" : "nodal";
  const auto found = find_stored(kind, name.text, n_components);
  if (!found || stored_.times.empty()) {
    const std::string components =
        n_components > 1 ? fmt::format(" with {} components", n_components) : std::string();
    diagnostics_.add_error(name.location,
                           stored_.times.empty() ? std::string("the mesh file holds no results to read from")
                                                 : fmt::format("the mesh file has no {} variable '{}'{}",
                                                               what, name.text, components),
                           suggest(name.text, kind.names), static_cast<int>(name.text.size()));
    return std::nullopt;
  }
  StoredValues values;
  for (const std::size_t component : *found)
    values.components.push_back(read_at(kind, component, time_of(variable)));
  return values;
}

}  // namespace contactsim

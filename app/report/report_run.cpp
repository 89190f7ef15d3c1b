// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/report_run.hpp"

#include <algorithm>

#include "core/definition/simulation.hpp"
#include "io/exodus/exodus_variables.hpp"

namespace contactsim {

namespace {

bool knows_death(const StoredVariables& stored, const StoredNames& names) {
  return std::ranges::any_of(names.on_file("death_status"), [&](const std::string& name) {
    return find_stored(stored.element, name, 1).has_value();
  });
}

}  // namespace

std::unique_ptr<const ReportMesh> make_report_mesh(const std::string& path, Mesh mesh,
                                                   const std::optional<ReportRegion>& region) {
  auto made = std::make_unique<ReportMesh>();
  made->mesh = std::move(mesh);
  made->stored = read_stored_variables(path, made->mesh);
  const StoredNames names = region ? StoredNames(region->region) : StoredNames();
  const ElementLife life = find_element_life(made->stored, made->mesh, names);
  made->geometry = make_report_geometry(made->mesh, region, life);
  made->fields = choose_report_fields(made->stored, names);
  const bool may_die = region && !region->region.element_deaths.empty();
  if (may_die && !made->stored.times.empty() && !knows_death(made->stored, names))
    made->fields.not_found.push_back(
        "Elements may die, but the results do not say which did, so dead ones are drawn too: output element "
        "death_status.");
  return made;
}

std::string title_of(const SimulationDefinition& definition) {
  return definition.title.empty() ? definition.name.text : definition.title;
}

}  // namespace contactsim

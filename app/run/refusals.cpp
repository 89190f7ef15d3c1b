// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/refusals.hpp"

#include "core/definition/procedure.hpp"

#include <fmt/format.h>

namespace contactsim {

namespace {

template <class Definition>
void refuse(const std::vector<Definition>& definitions, const char* what, Diagnostics& diagnostics) {
  for (const Definition& definition : definitions)
    diagnostics.add_error(definition.name.location, fmt::format("{} is not supported in a run yet", what));
}

}  // namespace

void refuse_what_is_missing(const Procedure& procedure, const Region& region, Diagnostics& diagnostics) {
  if (procedure.implicit_by) {
    diagnostics.add_error(procedure.implicit_by->location,
                          fmt::format("{} makes the procedure implicit", procedure.implicit_by->block),
                          "contactsim runs explicit procedures: PARAMETERS FOR PRESTO REGION");
  }
  if (!procedure.time_control) {
    diagnostics.add_error(procedure.name.location, "the procedure has no TIME CONTROL",
                          "without one --tables alone can be asked for");
  }
  refuse(region.spot_welds, "a spot weld", diagnostics);
  for (const MassProperties& properties : region.mass_properties) {
    diagnostics.add_warning("mass-properties", properties.name.location,
                            "mass properties are not reported yet; the log has the mass of every block");
  }
}

}  // namespace contactsim

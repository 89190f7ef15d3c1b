// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/refusals.hpp"

#include <fmt/format.h>

#include <string_view>

#include "core/definition/procedure.hpp"

namespace contactsim {

namespace {

template <class Definition>
void refuse(const std::vector<Definition>& definitions, const char* what, Diagnostics& diagnostics) {
  for (const Definition& definition : definitions)
    diagnostics.add_error(definition.name.location, fmt::format("{} is not supported in a run yet", what));
}

/// What load steps do not know yet, or cannot know.
void refuse_in_statics(const Region& region, Diagnostics& diagnostics) {
  const auto refuse_here = [&](const DeckName& name, std::string_view what, std::string hint = "") {
    diagnostics.add_error(name.location, fmt::format("{} in a quasi-static procedure is not supported", what),
                          std::move(hint));
  };
  for (const auto& death : region.element_deaths) refuse_here(death.name, "element death");
  for (const auto& scaling : region.mass_scalings) refuse_here(scaling.name, "mass scaling");
  for (const auto& damping : region.viscous_dampings) refuse_here(damping.name, "viscous damping");
  for (const auto& velocity : region.initial_velocities) refuse_here(velocity.name, "an initial velocity");
  for (const auto& condition : region.prescribed_conditions) {
    if (condition.quantity == PrescribedQuantity::acceleration)
      refuse_here(condition.name, "a prescribed acceleration",
                  "PRESCRIBED DISPLACEMENT says where nodes go, GRAVITY loads all of them");
  }
}

}  // namespace

void refuse_what_is_missing(const Procedure& procedure, const Region& region, Diagnostics& diagnostics) {
  if (procedure.implicit_by) refuse_in_statics(region, diagnostics);
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

// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/region_names.hpp"

#include <fmt/format.h>

#include "parser/commands/condition_names.hpp"
#include "parser/commands/contact_names.hpp"
#include "parser/commands/region_name_uses.hpp"

namespace contactsim {

namespace {

void check(const ElementDeath& death, const NameUses& uses) {
  uses.use(death.set);
  for (const DeckName& material : death.materials) uses.outside().materials.use(material, uses.diagnostics());
  if (!death.set.names_something() && death.materials.empty()) {
    uses.add_error(death.name, "the element death picks no elements",
                   "give it a BLOCK or ASSEMBLY line, or INCLUDE ALL BLOCKS");
  }
  if (death.criteria.empty() && !death.on_inversion && !death.on_ill_defined_contact) {
    uses.add_error(death.name, "the element death has no criterion", "give it a CRITERION line");
  }
}

void check(const SpotWeld& weld, const NameUses& uses) {
  uses.use(weld.normal);
  uses.use(weld.tangential);
  if (weld.failure_function) uses.outside().functions.use(*weld.failure_function, uses.diagnostics());
  if (weld.node_sets.empty()) uses.add_error(weld.name, "the spot weld has no NODE SET");
  if (weld.side_sets.empty()) uses.add_error(weld.name, "the spot weld has no SURFACE");
  if (!weld.normal.function && !weld.tangential.function) {
    uses.add_error(weld.name, "the spot weld has no DISPLACEMENT FUNCTION, normal or tangential");
  }
}

void check(const MassScaling& scaling, const NameUses& uses) {
  uses.use(scaling.set);
  if (!scaling.set.names_something()) {
    uses.add_error(scaling.name, "the mass scaling picks no part of the mesh",
                   "give it a BLOCK or NODE SET line, or INCLUDE ALL BLOCKS");
  }
  if (!scaling.target_time_step) uses.add_error(scaling.name, "the mass scaling has no TARGET TIME STEP");
}

void check(const AnalyticPlane& plane, const NameUses& uses) {
  if (plane.normal.isZero(0.0))
    uses.add_error(plane.name, "the analytic object has no normal", "give it a NORMAL DIRECTION line");
}

void check(const UserOutput& output, const NameUses& uses) {
  uses.use(output.set);
  for (const ComputedVariable& variable : output.variables) {
    const auto* function = std::get_if<FunctionVariable>(&variable);
    if (function != nullptr) uses.outside().functions.use(function->function, uses.diagnostics());
  }
}

template <class Output>
void check_schedules(const std::vector<Output>& outputs, const NameUses& uses) {
  for (const Output& output : outputs) uses.use(output.schedule);
}

}  // namespace

void resolve_region_names(const Region& region, OutsideNames& outside, Diagnostics& diagnostics) {
  const NameUses uses(outside, diagnostics);
  resolve_condition_names(region, uses);
  KnownNames planes("analytic object"), variables("user variable");
  for (const AnalyticPlane& plane : region.analytic_planes) {
    planes.define(plane.name, diagnostics);
    check(plane, uses);
  }
  for (const UserVariable& variable : region.user_variables) variables.define(variable.name, diagnostics);
  if (region.contact) resolve_contact_names(*region.contact, uses);
  for (const ElementDeath& death : region.element_deaths) check(death, uses);
  for (const SpotWeld& weld : region.spot_welds) check(weld, uses);
  for (const MassScaling& scaling : region.mass_scalings) check(scaling, uses);
  for (const MassProperties& properties : region.mass_properties) uses.use(properties.set);
  for (const UserOutput& output : region.user_outputs) check(output, uses);
  check_schedules(region.results_outputs, uses);
  check_schedules(region.history_outputs, uses);
  check_schedules(region.heartbeat_outputs, uses);
  check_schedules(region.restart_data, uses);
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/refusals.hpp"

#include <fmt/format.h>

#include <string_view>

#include "app/run/transfer_refusals.hpp"
#include "core/definition/procedure.hpp"
#include "core/definition/simulation.hpp"

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
  for (const auto& death : region.element_deaths) {
    if (death.on_inversion)
      refuse_here(death.name, "DEATH ON INVERSION",
                  "a step in which elements turn inside out is cut back; criteria look at equilibrium alone");
    if (!death.erodes_nodes && region.contact)
      refuse_here(death.name, "NODAL EROSION = OFF", "a node without elements has no equilibrium");
  }
  for (const auto& scaling : region.mass_scalings) refuse_here(scaling.name, "mass scaling");
  if (!region.subcycle_blocks.empty())
    refuse_here(region.subcycle_blocks.front(), "SUBCYCLE BLOCKS", "load steps have no stable step");
  for (const auto& damping : region.viscous_dampings) refuse_here(damping.name, "viscous damping");
  for (const auto& velocity : region.initial_velocities) refuse_here(velocity.name, "an initial velocity");
  for (const auto& condition : region.prescribed_conditions) {
    if (condition.quantity == PrescribedQuantity::acceleration)
      refuse_here(condition.name, "a prescribed acceleration",
                  "PRESCRIBED DISPLACEMENT says where nodes go, GRAVITY loads all of them");
  }
}

/// A block that is not closed may have swallowed the region or the procedure.
void refuse_without_times(const RunInput& input, Diagnostics& diagnostics) {
  const auto& procedures = input.definition.procedures;
  const DeckName& first = procedures.empty() ? input.definition.name : procedures.front().name;
  const bool is_known = input.procedure.name.location.is_known();
  const char* missing = "the procedure has no TIME CONTROL";
  if (procedures.empty()) missing = "the deck has no procedure";
  if (!procedures.empty() && !is_known && first.location.is_known()) missing = "the procedure has no region";
  diagnostics.add_error(is_known ? input.procedure.name.location : first.location, missing,
                        "without one --tables alone can be asked for");
}

}  // namespace

void refuse_what_is_missing(const RunInput& input, Diagnostics& diagnostics) {
  const Procedure& procedure = input.procedure;
  const Region& region = input.region;
  if (input.earlier != nullptr && !procedure.transfers.empty()) refuse_in_transfer(input, diagnostics);
  if (procedure.implicit_by) refuse_in_statics(region, diagnostics);
  if (!procedure.time_control) {
    refuse_without_times(input, diagnostics);
  }
  refuse(region.spot_welds, "a spot weld", diagnostics);
  for (const MassProperties& properties : region.mass_properties) {
    diagnostics.add_warning("mass-properties", properties.name.location,
                            "mass properties are not reported yet; the log has the mass of every block");
  }
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/refusals.hpp"

#include <fmt/format.h>

#include <string_view>

#include "app/run/simulation.hpp"
#include "core/definition/procedure.hpp"
#include "core/interface_laws/interface_law_table.hpp"
#include "core/statics/load_steps.hpp"

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
  for (const auto& damping : region.viscous_dampings) refuse_here(damping.name, "viscous damping");
  for (const auto& velocity : region.initial_velocities) refuse_here(velocity.name, "an initial velocity");
  for (const auto& condition : region.prescribed_conditions) {
    if (condition.quantity == PrescribedQuantity::acceleration)
      refuse_here(condition.name, "a prescribed acceleration",
                  "PRESCRIBED DISPLACEMENT says where nodes go, GRAVITY loads all of them");
  }
}

bool is_of_velocity(const InitialCondition& condition) {
  return condition.variable && fold(condition.variable->text) == "velocity";
}

/// Adds errors for what is not supported where a state is taken over.
class TransferRefusals {
 public:
  TransferRefusals(const RunInput& input, Diagnostics& diagnostics)
      : input_(input), diagnostics_(diagnostics) {}

  void refuse_earlier() const;
  void refuse_initial_conditions() const;
  void refuse_contact() const;

 private:
  bool takes_over_holding(const SurfacePair& pair) const;
  void refuse_here(const DeckLocation& location, std::string_view what, std::string hint = "") const {
    diagnostics_.add_error(location,
                           fmt::format("{} is not supported together with a PROCEDURAL TRANSFER", what),
                           std::move(hint));
  }

  const RunInput& input_;
  Diagnostics& diagnostics_;
};

void TransferRefusals::refuse_earlier() const {
  const Simulation& earlier = *input_.earlier;
  const DeckLocation& location = input_.procedure.transfers.front().name.location;
  if (earlier.deaths() != nullptr && input_.region.element_deaths.empty())
    refuse_here(location, "ELEMENT DEATH in the procedure before alone",
                "the same block in this region says which elements go on to die");
}

void TransferRefusals::refuse_initial_conditions() const {
  const Region& region = input_.region;
  for (const InitialCondition& condition : region.initial_conditions) {
    if (!is_of_velocity(condition))
      refuse_here(condition.name.location, "an initial condition of anything but velocity");
  }
  if (input_.earlier->load_steps() != nullptr) return;
  const char* why = "the velocities of the procedure before are taken over";
  for (const auto& velocity : region.initial_velocities)
    refuse_here(velocity.name.location, "an initial velocity", why);
  for (const InitialCondition& condition : region.initial_conditions) {
    if (is_of_velocity(condition)) refuse_here(condition.name.location, "an initial velocity", why);
  }
}

/// Whether a pair holds nothing from the start on, or may hold what the procedure before has held: all of it
/// in a procedure of the same kind, else what never fails.
bool TransferRefusals::takes_over_holding(const SurfacePair& pair) const {
  const InterfaceLawRow& law = row_of(*pair.law);
  if (!law.holds_at_start) return true;
  if (input_.earlier->contact_force() == nullptr) return false;
  const bool was_static = input_.earlier->load_steps() != nullptr;
  return input_.procedure.implicit_by.has_value() == was_static || law.holding == ContactLaw::tied;
}

/// What contact does once with the mesh, before the first step.
void TransferRefusals::refuse_contact() const {
  if (input_.contact == nullptr) return;
  const ContactDefinition& contact = *input_.region.contact;
  const char* why = "it acts on the mesh, not on the state that is taken over";
  if (contact.overlap_removal.is_on()) refuse_here(contact.name.location, "overlap removal", why);
  for (const SurfacePair& pair : input_.contact->pairs) {
    if (pair.closes_gaps()) return refuse_here(pair.location, "moving nodes onto the other side", why);
    if (!takes_over_holding(pair))
      return refuse_here(pair.location, "contact that holds what is near at the start", why);
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
  if (input.earlier != nullptr && !procedure.transfers.empty()) {
    const TransferRefusals refusals(input, diagnostics);
    refusals.refuse_earlier();
    refusals.refuse_initial_conditions();
    refusals.refuse_contact();
  }
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

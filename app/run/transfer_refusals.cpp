// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/transfer_refusals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "app/run/simulation.hpp"
#include "core/definition/procedure.hpp"
#include "core/interface_laws/interface_law_table.hpp"
#include "core/statics/load_steps.hpp"

namespace contactsim {

namespace {

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

}  // namespace

void refuse_in_transfer(const RunInput& input, Diagnostics& diagnostics) {
  const TransferRefusals refusals(input, diagnostics);
  refusals.refuse_earlier();
  refusals.refuse_initial_conditions();
  refusals.refuse_contact();
}

void refuse_held_without_transfer(const SurfacePairs& pairs, Diagnostics& diagnostics) {
  const auto held =
      std::ranges::find_if(pairs, [](const SurfacePair& pair) { return row_of(*pair.law).holds_at_start; });
  if (held == pairs.end()) return;
  diagnostics.add_error(
      held->location,
      "contact that holds what is near at the start is not supported where a PROCEDURAL TRANSFER takes over "
      "no contact",
      "it goes on with INCLUDE ALL BLOCKS, and the surfaces and interactions of the procedure before");
}

}  // namespace contactsim

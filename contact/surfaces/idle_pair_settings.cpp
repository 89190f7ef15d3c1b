// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/idle_pair_settings.hpp"

#include <optional>

namespace contactsim {

namespace {

/// Warns of a way of enforcement that is of the other kind of procedure.
void warn_of_foreign_enforcement(const ContactDefinition& contact, Diagnostics& diagnostics) {
  const bool is_static = contact.enforcement.is_static;
  const Enforcement foreign = is_static ? Enforcement::momentum_balance : Enforcement::augmented_lagrange;
  const auto look_at = [&](const std::optional<Enforcement>& enforcement, const DeckName& name) {
    if (enforcement != foreign) return;
    diagnostics.add_warning("enforcement-of-other-procedures", name.location,
                            is_static
                                ? "ENFORCEMENT = MOMENTUM_BALANCE has no effect in a quasi-static "
                                  "procedure, where nothing has momentum"
                                : "ENFORCEMENT = AUGMENTED_LAGRANGE has no effect in an explicit procedure, "
                                  "where momentum is balanced",
                            is_static ? "AUGMENTED_LAGRANGE, the default, lets nothing through"
                                      : "MOMENTUM_BALANCE, the default, lets nothing through");
  };
  look_at(contact.enforcement.enforcement, contact.name);
  if (contact.interaction_defaults)
    look_at(contact.interaction_defaults->pair.enforcement, contact.interaction_defaults->name);
  for (const Interaction& interaction : contact.interactions)
    look_at(interaction.pair.enforcement, interaction.name);
}

/// Warns of stabilization where inertia holds bodies.
void warn_of_idle_stabilization(const ContactDefinition& contact, Diagnostics& diagnostics) {
  if (contact.enforcement.is_static) return;
  const auto look_at = [&](const PairSettings& pair, const DeckName& name) {
    if (pair.stabilization.is_on())
      diagnostics.add_warning("stabilization-of-other-procedures", name.location,
                              "CONTACT STABILIZATION has no effect in an explicit procedure, where inertia "
                              "holds what does not touch yet",
                              "CONTACT DAMPING FRACTION with ENFORCEMENT = PENALTY damps contact there");
  };
  if (contact.interaction_defaults)
    look_at(contact.interaction_defaults->pair, contact.interaction_defaults->name);
  for (const Interaction& interaction : contact.interactions) look_at(interaction.pair, interaction.name);
}

}  // namespace

void warn_of_idle_pair_settings(const ContactDefinition& contact, Diagnostics& diagnostics) {
  warn_of_foreign_enforcement(contact, diagnostics);
  warn_of_idle_stabilization(contact, diagnostics);
}

}  // namespace contactsim

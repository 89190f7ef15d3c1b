// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/definition/condition_lines.hpp"
#include "core/definition/contact_options.hpp"
#include "core/definition/contact_surfaces.hpp"
#include "core/definition/friction.hpp"
#include "core/definition/interaction.hpp"
#include "core/definition/surface_smoothing.hpp"

namespace contactsim {

/// BEGIN CONTACT DEFINITION [name] ... END. Source: Sierra/SM 5.22, 8.3.
struct ContactDefinition {
  DeckName name;
  std::vector<SurfaceCommand> surface_commands;  ///< in deck order, which decides who owns a face
  std::optional<ContactSubdomain> subdomain;
  std::vector<FrictionModel> friction_models;  ///< FRICTIONLESS and TIED need no definition
  std::optional<InteractionDefaults> interaction_defaults;
  std::vector<Interaction> interactions;  ///< in deck order: a later one overrides an earlier one
  ActivePeriods periods;
  SearchOptions search;
  DashOptions dash;
  EnforcementOptions enforcement;
  std::vector<SurfaceOptions> surface_options;  ///< in deck order: a later one overrides an earlier one
  std::vector<SurfaceSmoothing> smoothings;
  OverlapRemoval overlap_removal;
  ContactVariables variables = ContactVariables::when_written;
  ContactDebug debug;
};

}  // namespace contactsim

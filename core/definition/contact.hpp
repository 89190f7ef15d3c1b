// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/definition/contact_surfaces.hpp"

namespace contactsim {

/// BEGIN CONTACT DEFINITION [name] ... END. Source: Sierra/SM 5.22, 8.3.
struct ContactDefinition {
  DeckName name;
  std::vector<SurfaceCommand> surface_commands;  ///< in deck order, which decides who owns a face
  std::optional<ContactSubdomain> subdomain;
};

}  // namespace contactsim

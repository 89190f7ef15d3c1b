// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/definition/entity_set.hpp"
#include "core/definition/region.hpp"
#include "core/definition/time_control.hpp"

namespace contactsim {

/// BEGIN PROCEDURAL TRANSFER <name>: takes the state of blocks over from the procedure before.
struct ProceduralTransfer {
  DeckName name;
  EntitySet set;  ///< blocks alone
};

/// The block that makes a procedure implicit.
struct ImplicitCause {
  std::string block;  ///< as a message names it: "adagio region 'r'"
  DeckLocation location;
};

/// BEGIN {PRESTO | ADAGIO | SOLID MECHANICS} PROCEDURE <name>.
struct Procedure {
  DeckName name;
  std::optional<TimeControl> time_control;
  std::vector<ProceduralTransfer> transfers;
  std::vector<Region> regions;               ///< in deck order
  std::optional<ImplicitCause> implicit_by;  ///< absent: explicit; the first cause in the deck
};

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/definition/contact.hpp"

namespace contactsim {

/// BEGIN {PRESTO | ADAGIO | SOLID MECHANICS} REGION <name> ... END: one model, what acts on it, what is
/// written.
struct Region {
  DeckName name;
  std::optional<DeckName> finite_element_model;  ///< USE FINITE ELEMENT MODEL
  std::vector<AnalyticPlane> analytic_planes;
  std::optional<ContactDefinition> contact;
};

}  // namespace contactsim

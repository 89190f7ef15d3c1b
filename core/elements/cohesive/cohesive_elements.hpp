// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/element_table.hpp"

namespace contactsim {

/// The rows of cohesive elements, of eight and of six nodes.
extern const ElementFormulation cohesive8_pairs;
extern const ElementFormulation cohesive6_pairs;

}  // namespace contactsim

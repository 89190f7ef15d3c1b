// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/section.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// One row for each type of BEGIN <type> SECTION, added to a list of sections.
std::vector<Row<std::vector<SectionDefinition>>> section_rows();

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/compare/comparison.hpp"
#include "app/compare/ownership_table.hpp"

namespace contactsim {

/// Names of surfaces in the second of two tables, by their names in the first.
using NewNames = std::map<std::string, std::string>;

/// The name of a surface in the second table.
const std::string& renamed(const std::string& name, const NewNames& new_names);

/// Tells of pairs that one table has alone, of settings that differ, and in how many pairs the surfaces stand
/// the other way round.
void add_pairs(const OwnershipTable& first, const OwnershipTable& second, const NewNames& new_names,
               std::vector<Difference>& differences);

}  // namespace contactsim

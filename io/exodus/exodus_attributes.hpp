// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Names of a block's attributes by their position, for files that do not name them. `block` has its type,
/// shape and nodes per element. Source: Exodus II manual (SAND92-2137), section 4.8 and table 1; IOSS for the
/// ten attributes of sphere-mass.
std::vector<std::string> default_attribute_names(const ElementBlock& block, std::size_t n_attributes);

}  // namespace contactsim

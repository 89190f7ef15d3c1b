// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Whether any attribute of the block has a name.
bool has_attribute_names(const ElementBlock& block);

/// The attribute of an element by name, compared without case; nothing when the block has none of the name.
///   element  position in the block
std::optional<double> find_named_attribute(const ElementBlock& block, std::uint32_t element,
                                           std::string_view name);

/// The attribute of an element: by its usual name when the block has it, else the first column. All columns
/// of a shell that has one per node count, as their mean. Source: Exodus II attribute order, SAND92-2137.
std::optional<double> find_usual_attribute(const ElementBlock& block, std::uint32_t element,
                                           std::string_view name);

}  // namespace contactsim

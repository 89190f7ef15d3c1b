// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

namespace contactsim {

/// A friction model that needs no definition.
struct BuiltInFriction {
  std::string_view name;  ///< lower case
  std::string_view law;   ///< name of its row in core/interface_laws/interface_law_table.hpp
};

/// FRICTIONLESS and TIED as in Sierra/SM; STICK and FREEZE as in OptiStruct's PCONT.
inline constexpr std::array built_in_friction{
    BuiltInFriction{"frictionless", "frictionless"}, BuiltInFriction{"tied", "tied"},
    BuiltInFriction{"stick", "stick"}, BuiltInFriction{"freeze", "tied"}};

}  // namespace contactsim

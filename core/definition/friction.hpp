// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/definition/parameter_values.hpp"

namespace contactsim {

/// What two surfaces do to each other where they touch, and some also where they stand apart.
struct FrictionLaw {
  std::string type = "frictionless";  ///< name of its row in core/interface_laws/interface_law_table.hpp
  ParameterValues values = {};
  bool operator==(const FrictionLaw&) const = default;
};

/// BEGIN ... MODEL <name>: a law that interactions use by its name.
struct FrictionModel {
  DeckName name;
  FrictionLaw law;
};

/// The law that a name stands for: the first model so called, else one of FRICTIONLESS and TIED, which need
/// no definition; null when there is none. The result lives as long as `models`.
const FrictionLaw* find_friction_law(std::span<const FrictionModel> models, std::string_view name);

}  // namespace contactsim

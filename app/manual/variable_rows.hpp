// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace contactsim {

/// What the reference says of an output variable.
struct VariableText {
  std::string location;  ///< "global", "nodal", "element"
  std::string name;      ///< of those of surfaces, "contact_force_<surface or side set>"
  int n_components = 1;  ///< 0 for the name of a group of variables
  std::string help;
};

/// Every output variable of every model, from the rows that fill them.
std::vector<VariableText> output_variables();

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/definition/output_variable.hpp"
#include "core/mesh/output_field.hpp"

namespace contactsim {

class OutputVariables;

/// Row of a table of names that stand for several output variables of one location.
struct OutputGroup {
  std::string_view name;  ///< as decks ask for it, lower case
  FieldLocation location = FieldLocation::node;
  std::span<const std::string_view> members;
  std::string_view help;  ///< one line: what they are together
};

/// Row of a table of other programs' names for what output variables of ours hold, for hints.
struct ForeignVariable {
  std::string_view name;  ///< lower case
  std::string_view ours;  ///< the name here
};

/// Names that are no variables; the tables must outlive whoever has them.
struct OutputNames {
  std::span<const OutputGroup> groups;
  std::span<const ForeignVariable> foreign;
};

/// The requests with each group replaced by requests for its members, at the group's place. A group has no
/// components and takes no alias: what asks for one is reported ("output-group").
std::vector<VariableRequest> expand_groups(const OutputVariables& variables,
                                           std::span<const VariableRequest> requests,
                                           Diagnostics& diagnostics);

}  // namespace contactsim

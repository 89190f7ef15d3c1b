// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/definition/output_user.hpp"
#include "core/output/variable_pick.hpp"

namespace contactsim {

/// Goes through the values of many entities in order, some at a time: visit(range, values) with values
/// [range.count x n_components]. Ranges in blocks that lack the variable are left out.
template <class Visit>
void visit_values(const VariablePick& pick, std::span<const EntityRange> ranges, const OutputMoment& moment,
                  Visit visit) {
  constexpr std::size_t most = 1u << 14;
  std::vector<double> values;
  for (const EntityRange& range : ranges) {
    if (pick.variable->location == FieldLocation::element && !pick.is_in_block(moment.model, range.block))
      continue;
    for (std::size_t begin = 0; begin < range.count; begin += most) {
      const EntityRange part{range.block, range.first + begin, std::min(most, range.count - begin), {}};
      values.resize(part.count * pick.n_components());
      fill(pick, moment, part, values);
      visit(part, std::span<const double>(values));
    }
  }
}

/// Makes one value of each component of many entities, in their order: sum, maximum, minimum, mean, largest
/// absolute value, root of the sum of squares, mean squared distance from the mean. Of no entities the sums
/// are 0 and the rest is not a number; a value that is not a number makes the result one.
/// Source: Sierra/SM 5.22, 9.4.
std::vector<double> reduce(OutputReduction reduction, const VariablePick& pick,
                           std::span<const EntityRange> ranges, const OutputMoment& moment);

}  // namespace contactsim

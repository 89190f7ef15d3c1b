// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/definition/output_user.hpp"
#include "core/output/shared_values.hpp"

namespace contactsim {

/// Goes through the values of many entities in order, some at a time: visit(range, values) with values
/// [range.count x n_components]. Ranges in blocks that lack the variable are left out. On several ranks all
/// call it alike.
template <class Visit>
void visit_values(const VariableSelection& selection, std::span<const EntityRange> ranges,
                  const OutputContext& context, Visit visit) {
  constexpr std::size_t max_count = 1u << 14;
  std::vector<double> values;
  for (const EntityRange& range : ranges) {
    if (selection.variable->location == FieldLocation::element &&
        !selection.is_in_block(context.model, range.block))
      continue;
    for (std::size_t begin = 0; begin < range.count; begin += max_count) {
      const EntityRange part{range.block, range.first + begin, std::min(max_count, range.count - begin), {}};
      values.resize(part.count * selection.n_components());
      if (context.share != nullptr) {
        fill_from_ranks(selection, context, part, values);
      } else {
        fill(selection, context, part, values);
      }
      visit(part, std::span<const double>(values));
    }
  }
}

/// Makes one value of each component of many entities, in their order: sum, maximum, minimum, mean, largest
/// absolute value, root of the sum of squares, mean squared distance from the mean. Of no entities the sums
/// are 0 and the rest is not a number; a value that is not a number makes the result one.
/// Source: Sierra/SM 5.22, 9.4.
std::vector<double> reduce(OutputReduction reduction, const VariableSelection& selection,
                           std::span<const EntityRange> ranges, const OutputContext& context);

}  // namespace contactsim

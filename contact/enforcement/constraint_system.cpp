// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/constraint_system.hpp"

namespace contactsim {

void ConstraintSystem::clear() {
  points.clear();
  groups.clear();
  rows.clear();
  weights.clear();
  ids.clear();
  frictions.clear();
}

bool ConstraintSystem::is_of_last_group(const ContactPoint& point) const {
  if (rows.empty() || groups.back().terms.first_arm) return false;
  const ContactPoint& last = point_of(rows.back());
  return point.first.nodes == last.first.nodes && point.second.nodes == last.second.nodes &&
         point.normal == last.normal;
}

void ConstraintSystem::remove_rigid_rows() {
  std::uint32_t n_kept = 0;
  for (ConstraintGroup& group : groups) {
    const std::uint32_t first = group.first_row, end = first + group.n_rows;
    group.first_row = n_kept;
    for (std::uint32_t i = first; i < end; ++i) {
      if (!(rows[i].softness > 0.0)) continue;
      rows[n_kept] = rows[i];
      weights[n_kept] = weights[i];
      ids[n_kept++] = ids[i];
    }
    group.n_rows = n_kept - group.first_row;
  }
  rows.resize(n_kept);
  weights.resize(n_kept);
  ids.resize(n_kept);
  std::erase_if(groups, [](const ConstraintGroup& group) { return group.n_rows == 0; });
}

}  // namespace contactsim

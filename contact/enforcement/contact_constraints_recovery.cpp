// SPDX-License-Identifier: BSD-3-Clause
// How much of what has penetrated comes out in a step.
#include <algorithm>
#include <map>

#include "contact/enforcement/contact_constraints.hpp"
#include "contact/enforcement/relative_velocity.hpp"

namespace contactsim {

namespace {

/// What comes out in a step whatever it takes, over the motion of the sides against each other: by that much
/// of their speed they may part, and contact gives as much of what it takes in all.
constexpr double free_recovery = 4e-3;

}  // namespace

/// Pushing out by r takes a force of that of the step before and r / c at least, which works along r. To part
/// sides d deep takes no more than d^2 / 2 c: 1 / c is about the stiffness of what is behind a point, since
/// the step is about the stable one.
void ContactConstraints::limit_recovery(RecoveryEnergy& recovery) {
  needs_.resize(system_.rows.size());
  parallel_for(system_.groups.size(), system_.n_threads(), [&](std::size_t of_group) {
    system_.visit_rows({&system_.groups[of_group], 1}, [&](const Group& group, std::uint32_t i) {
      const Row& row = system_.rows[i];
      needs_[i].recovery = 0.0;
      if (!(row.recovery > 0.0)) return;
      const ContactPoint& point = system_.points[row.point];
      const double depth = row.zero_gap - point.gap, pressing = std::max(0.0, row.force.dot(group.normal));
      needs_[i] = {point.pair, (pressing + row.recovery / row.softness) * row.recovery,
                   0.5 * depth * depth / row.softness};
    });
  });
  std::map<PairIndex, double> needed;
  auto of_pair = needed.end();  // points of a pair follow each other, mostly
  for (const Need& need : needs_) {
    if (!(need.recovery > 0.0)) continue;
    if (recovery.has_begun(need.pair)) recovery.add_overlap(need.pair, need.parting);
    if (of_pair == needed.end() || of_pair->first != need.pair)
      of_pair = needed.try_emplace(need.pair, 0.0).first;
    of_pair->second += need.recovery;
  }
  std::erase_if(needed, [&](const auto& of) { return of.second <= recovery.available(of.first); });
  if (needed.empty()) return;
  system_.visit_rows([&](const Group&, std::uint32_t i) {
    Row& row = system_.rows[i];
    if (!(row.recovery > 0.0)) return;
    const ContactPoint& point = system_.points[row.point];
    const auto found = needed.find(point.pair);
    if (found == needed.end()) return;
    const double paid = recovery.available(found->first) / found->second * row.recovery;
    const double slow = free_recovery * dt_ * relative_velocity(*kinematics_, point, false).norm();
    const double unpaid = std::max(0.0, row.recovery - std::max(paid, slow));
    const double opened = dt_ * std::max(0.0, point.normal.dot(relative_velocity(*kinematics_, point, true)));
    row.start += unpaid + unpaid / row.recovery * opened;
  });
}

}  // namespace contactsim

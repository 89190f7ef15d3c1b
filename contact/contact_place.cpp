// SPDX-License-Identifier: BSD-3-Clause
#include "contact/contact_place.hpp"

#include <algorithm>
#include <cmath>

namespace contactsim {

double damped_stiffness(double stiffness, double fraction) {
  const double factor = fraction + std::sqrt(1.0 + fraction * fraction);
  return stiffness * factor * factor;
}

void push_node(const NodePush& push, ContactRecord& record) {
  if (push.coming_dt > 0.0) {
    record.is_balanced = true;
    record.area = push.area;
    record.closing = -push.velocity.dot(record.normal) * push.coming_dt;
    return;
  }
  const PairPenalty& penalty = push.penalty;
  const double speed = push.velocity.dot(record.normal), stiffness = penalty.stiffness * push.area;
  const double depth_ahead = -record.gap - std::min(0.0, speed) * push.dt;
  record.stiffness = damped_stiffness(stiffness * penalty.law.slope(depth_ahead), push.damping_fraction);
  if (record.gap >= 0.0) return;
  const double spring = stiffness * penalty.law.spring_depth(-record.gap);
  const double damper = std::max(-penalty.damping * push.area * speed, -spring);
  record.beyond_spring = stiffness * penalty.law.potential(-record.gap) + 0.5 * spring * record.gap;
  record.area = push.area;
  record.deepest = -record.gap;
  record.force = spring + damper;
  record.damped = -damper * speed * push.dt;
  record.slip = push.velocity * push.dt;
}

}  // namespace contactsim

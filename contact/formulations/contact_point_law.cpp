// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/contact_point_law.hpp"

#include <algorithm>
#include <cmath>

namespace contactsim {

double damped_stiffness(double stiffness, double fraction) {
  const double factor = fraction + std::sqrt(1.0 + fraction * fraction);
  return stiffness * factor * factor;
}

void push_node(const NodePenaltyInput& push, ContactPoint& point) {
  if (push.coming_dt > 0.0) {
    point.is_balanced = true;
    point.area = push.area;
    point.closing = -push.velocity.dot(point.normal) * push.coming_dt;
    return;
  }
  const PairPenalty& penalty = push.penalty;
  const double speed = push.velocity.dot(point.normal), stiffness = penalty.stiffness * push.area;
  const double depth_ahead = -point.gap - std::min(0.0, speed) * push.dt;
  point.stiffness = damped_stiffness(stiffness * penalty.law.slope(depth_ahead), push.damping_fraction);
  if (point.gap >= 0.0) return;
  const double spring = stiffness * penalty.law.spring_depth(-point.gap);
  const double damper = std::max(-penalty.damping * push.area * speed, -spring);
  point.beyond_spring = stiffness * penalty.law.potential(-point.gap) + 0.5 * spring * point.gap;
  point.area = push.area;
  point.deepest = -point.gap;
  point.force = spring + damper;
  point.damped = -damper * speed * push.dt;
  point.slip = push.velocity * push.dt;
}

}  // namespace contactsim

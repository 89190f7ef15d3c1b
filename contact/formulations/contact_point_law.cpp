// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/contact_point_law.hpp"

#include <algorithm>
#include <cmath>

#include "core/interface_laws/pressure_law.hpp"

namespace contactsim {

double damped_stiffness(double stiffness, double fraction) {
  const double factor = fraction + std::sqrt(1.0 + fraction * fraction);
  return stiffness * factor * factor;
}

namespace {

/// The force of a node's spring, or of its pressure, at a depth behind where it begins, and what it stores.
struct NodeSpring {
  double force = 0.0, stored = 0.0;
};

NodeSpring spring_at(const NodePenaltyInput& push, double depth) {
  const PairPenalty& penalty = push.penalty;
  if (penalty.pressure != nullptr && depth > 0.0)
    return {push.area * penalty.pressure->at(depth), push.area * penalty.pressure->potential(depth)};
  const double stiffness = penalty.stiffness * push.area;
  return {stiffness * penalty.law.spring_depth(depth), stiffness * penalty.law.potential(depth)};
}

}  // namespace

void push_node(const NodePenaltyInput& push, ContactPoint& point) {
  if (push.coming_dt > 0.0) {
    point.is_balanced = true;
    point.area = push.area;
    point.closing = -push.velocity.dot(point.normal) * push.coming_dt;
    return;
  }
  const PairPenalty& penalty = push.penalty;
  const double speed = push.velocity.dot(point.normal), stiffness = penalty.stiffness * push.area;
  const double ahead = push.is_static ? 0.0 : push.dt;
  const double depth_ahead = -point.gap - std::min(0.0, speed) * ahead;
  const double slope = penalty.pressure == nullptr ? stiffness * penalty.law.slope(depth_ahead)
                                                   : push.area * penalty.slope_of_pressure(depth_ahead);
  point.stiffness = damped_stiffness(slope, push.damping_fraction);
  if (point.pulls)
    point.stiffness = std::max(point.stiffness, damped_stiffness(stiffness, push.damping_fraction));
  if (point.gap >= 0.0 && !point.pulls) return;
  const NodeSpring found = spring_at(push, -point.gap);
  const double spring = found.force;
  const double undamped = -penalty.damping * penalty.damping_factor(-point.gap) * push.area * speed;
  const double damper = point.pulls ? undamped : std::max(undamped, -spring);
  point.beyond_spring = found.stored + 0.5 * spring * point.gap;
  point.area = push.area;
  point.deepest = std::max(0.0, -point.gap);
  point.force = spring + damper;
  point.damped = -damper * speed * push.dt;
  point.slip = push.velocity * push.dt;
}

}  // namespace contactsim

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
  record.stiffness = damped_stiffness(push.penalty.stiffness * push.area, push.damping_fraction);
  if (record.gap >= 0.0) return;
  const double speed = push.velocity.dot(record.normal);
  const double spring = -push.penalty.stiffness * push.area * record.gap;
  const double damper = std::max(-push.penalty.damping * push.area * speed, -spring);
  record.area = push.area;
  record.force = spring + damper;
  record.damped = -damper * speed * push.dt;
  record.slip = push.velocity * push.dt;
}

}  // namespace contactsim

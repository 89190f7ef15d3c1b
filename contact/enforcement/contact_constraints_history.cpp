// SPDX-License-Identifier: BSD-3-Clause
// What momentum balance knows of contact points from the step before, or from load steps.
#include <limits>

#include "contact/enforcement/contact_constraints.hpp"

namespace contactsim {

/// What is known of a point; nothing is of the gap at which what load steps have pressed touches.
std::optional<ContactHistory::Entry> ContactConstraints::recall(const ContactPoint& contact_point) {
  ContactHistory::Entry known;
  if (!history_.recall(contact_point, known)) return std::nullopt;
  return known;
}

void ContactConstraints::begin_pressed(std::span<const ContactPoint> points) {
  begins_pressed_ = true;
  history_.begin();
  for (const ContactPoint& point : points) {
    if (!(point.area > 0.0) || !(point.force > 0.0)) continue;
    ContactHistory::Entry entry{point.force / point.area, point.tangential / point.area};
    entry.area = point.area;
    entry.zero_gap = std::numeric_limits<double>::quiet_NaN();
    history_.remember(point, entry);
  }
  history_.end();
}

std::vector<ContactPoint> ContactConstraints::begun_points() const {
  std::vector<ContactPoint> points = points_;
  for (const Row& row : rows_) {
    ContactPoint& point = points[row.point];
    const Eigen::Vector3d force = row.force.head<3>();
    const double pressing = force.dot(point.normal);
    point.force += pressing;
    point.tangential += force - pressing * point.normal;
  }
  return points;
}

}  // namespace contactsim

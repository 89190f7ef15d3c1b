// SPDX-License-Identifier: BSD-3-Clause
// What momentum balance knows of contact points from the step before, or from load steps.
#include <algorithm>
#include <limits>

#include "contact/enforcement/contact_constraints.hpp"

namespace contactsim {

/// What is known of a point; nothing is of the gap at which what load steps have pressed touches.
std::optional<ContactHistory::Entry> ContactConstraints::recall(const ContactHistory::PointId& id) {
  ContactHistory::Entry known;
  if (!history_.recall(id, known)) return std::nullopt;
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
    if (point.first.is_node()) pressed_by_nodes_[point.pair] += point.force;
  }
  history_.end();
}

void ContactConstraints::spread_pressed() {
  spread_over_faces();
  std::map<PairIndex, double> forces;
  for (const Row& row : system_.rows) {
    const ContactPoint& point = system_.points[row.point];
    if (point.first.is_node()) forces[point.pair] += row.force.head<3>().dot(point.normal);
  }
  for (Row& row : system_.rows) {
    const ContactPoint& point = system_.points[row.point];
    if (point.first.is_node() && forces[point.pair] > 0.0)
      row.force *= std::min(1.0, pressed_by_nodes_[point.pair] / forces[point.pair]);
  }
  pressed_by_nodes_.clear();
}

void ContactConstraints::spread_over_faces() {
  const auto are_alike = [this](const Row& a, const Row& b) {
    const ContactPoint &one = system_.points[a.point], &other = system_.points[b.point];
    return one.first_entity == other.first_entity && one.second_entity == other.second_entity;
  };
  for (auto begin = system_.rows.begin(), end = begin; begin != system_.rows.end(); begin = end) {
    const ContactPoint& point = system_.points[begin->point];
    double force = 0.0;
    for (; end != system_.rows.end() && are_alike(*begin, *end); ++end)
      force += end->force.head<3>().dot(system_.points[end->point].normal);
    if (point.first.is_node() || point.is_of_edges || !(force > 0.0)) continue;
    const double share = std::min(1.0, history_.force_between(point) / force);
    std::for_each(begin, end, [share](Row& row) { row.force *= share; });
  }
}

std::vector<ContactPoint> ContactConstraints::begun_points() const {
  std::vector<ContactPoint> points = system_.points;
  for (const Row& row : system_.rows) {
    ContactPoint& point = points[row.point];
    const Eigen::Vector3d force = row.force.head<3>();
    const double pressing = force.dot(point.normal);
    point.force += pressing;
    point.tangential += force - pressing * point.normal;
  }
  return points;
}

}  // namespace contactsim

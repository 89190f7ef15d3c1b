// SPDX-License-Identifier: BSD-3-Clause
// What each contact point and tie of a step adds.
#include <algorithm>
#include <array>
#include <cmath>

#include "contact/output/contact_output.hpp"

namespace contactsim {

void ContactOutput::add_place(const ContactPoint& contact_point) {
  add_to_nodes(contact_point, contact_point.first, 1.0);
  add_to_nodes(contact_point, contact_point.second, -1.0);
  if (!contact_point.touches()) return;
  Eigen::Vector3d point_position = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < 4; ++k)
    point_position += contact_point.first.weights[static_cast<Eigen::Index>(k)] *
                      force_.position(contact_point.first.nodes[k]);
  ContactTotal total;
  total.add(point_position, contact_point.force * contact_point.normal, contact_point.tangential);
  total.normal_sum = contact_point.force;
  total.centre = contact_point.force * point_position;
  total.area = contact_point.area;
  add_to_totals(contact_point.pair, contact_point.is_swapped, total);
}

void ContactOutput::add_to_nodes(const ContactPoint& contact_point, const ContactPointSide& side,
                                 double sign) {
  const bool has_friction = force_.rules().of(contact_point).friction > 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double weight = side.weights[static_cast<Eigen::Index>(k)];
    if (weight == 0.0) continue;
    NodeContact& node = nodes_[force_.contact_mesh().first_alike[side.nodes[k]]];
    const bool is_first_place = node.interaction == 0.0;
    node.interaction = contact_point.pair.value + 1.0;
    if (is_first_place || contact_point.open_gap() < node.gap) {
      node.gap = contact_point.open_gap();
      node.tangential_gap = contact_point.elastic_slip.norm();
    }
    if (!contact_point.touches()) continue;
    node.status = 1.0;
    if (has_friction)
      node.slip_status = std::max(node.slip_status, contact_point.slip.isZero(0.0) ? 1.0 : 2.0);
    node.normal += sign * weight * contact_point.force * contact_point.normal;
    node.tangential += sign * weight * contact_point.tangential;
    node.area += weight * contact_point.area;
  }
}

void ContactOutput::add_tie(const InterfaceConstraint& tie, const CornerForces& forces) {
  if (forces.normal.isZero()) return;
  ContactTotal total;
  total.area = tie.area;
  for (std::size_t k = 0; k < 8; ++k) {
    const Eigen::Vector3d force = forces.forces.col(static_cast<Eigen::Index>(k));
    const bool is_first = k < 4;
    const auto same = std::find(tie.nodes.begin() + (is_first ? 0 : 4),
                                tie.nodes.begin() + static_cast<int>(k), tie.nodes[k]);
    NodeContact& node = nodes_[force_.contact_mesh().first_alike[tie.nodes[k]]];
    const Eigen::Vector3d normal = forces.normal.dot(force) * forces.normal;
    node.status = node.slip_status = 1.0;
    node.interaction = tie.pair.value + 1.0;
    node.normal += normal;
    node.tangential += force - normal;
    const bool is_repeated = same != tie.nodes.begin() + static_cast<int>(k);
    if (!is_repeated) node.area += tie.area * tie_share(tie, is_first);
    if (!is_first) continue;
    total.add(force_.position(tie.nodes[k]), normal, force - normal);
    total.normal_sum += std::abs(normal.norm());
    total.centre += normal.norm() * force_.position(tie.nodes[k]);
  }
  add_to_totals(tie.pair, tie.is_swapped, total);
}

double ContactOutput::tie_share(const InterfaceConstraint& tie, bool is_first) {
  std::array<ContactNodeIndex, 4> nodes;
  std::copy_n(tie.nodes.begin() + (is_first ? 0 : 4), 4, nodes.begin());
  std::sort(nodes.begin(), nodes.end());
  return 1.0 / static_cast<double>(std::unique(nodes.begin(), nodes.end()) - nodes.begin());
}

}  // namespace contactsim

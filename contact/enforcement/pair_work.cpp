// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/pair_work.hpp"

#include <utility>

#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

/// Power of a force on a contact node and a moment about it [energy/time].
double power(const ContactKinematics& kinematics, ContactNodeIndex node, const Eigen::Vector3d& force,
             const Eigen::Vector3d& moment) {
  const double of_force = force.dot(kinematics.last_v(node));
  return moment.isZero(0.0) ? of_force : of_force + moment.dot(kinematics.last_turning(node));
}

/// Calls visit(node, force, moment) for each node of one side of a contact point.
template <class Visit>
void visit_side(const ContactPointSide& side, const Eigen::Vector3d& force, const Eigen::Vector3d& arm,
                const Visit& visit) {
  for (std::size_t k = 0; k < 4; ++k) {
    const double weight = side.weights[static_cast<Eigen::Index>(k)];
    if (weight == 0.0) continue;
    const Eigen::Vector3d own = weight * force;
    const Eigen::Vector3d moment =
        side.radius == 0.0 ? Eigen::Vector3d::Zero() : Eigen::Vector3d(arm.cross(own));
    visit(side.nodes[k], own, moment);
  }
}

template <class Visit>
void visit_forces(const ContactPoint& point, const Visit& visit) {
  if (!point.touches()) return;
  const Eigen::Vector3d force = point.force_on_first();
  visit_side(point.first, force, -point.first.radius * point.normal, visit);
  visit_side(point.second, -force, point.second.radius * point.normal, visit);
}

}  // namespace

void PairWork::begin_step(const ContactKinematics& kinematics, double dt) {
  half_ = 0.5 * dt;
  for (const NodeForce& f : forces_) taken_[f.pair] -= half_ * power(kinematics, f.node, f.force, f.moment);
  forces_.clear();
  for (const PairIndex pair : indices(taken_)) taken_[pair] += std::exchange(coming_[pair], 0.0);
}

void PairWork::add(const ContactKinematics& kinematics, const NodeForce& f) {
  taken_[f.pair] -= half_ * power(kinematics, f.node, f.force, f.moment);
  forces_.push_back(f);
}

void PairWork::add(const ContactKinematics& kinematics, const ContactPoint& point) {
  if (point.knows_work) {
    taken_[point.pair] += point.work_before;
    coming_[point.pair] += point.work_after;
    return;
  }
  visit_forces(point,
               [&](ContactNodeIndex node, const Eigen::Vector3d& force, const Eigen::Vector3d& moment) {
                 add(kinematics, {point.pair, node, force, moment});
               });
}

double PairWork::work_behind(const ContactKinematics& kinematics, const ContactPoint& point) const {
  double sum = 0.0;
  visit_forces(point,
               [&](ContactNodeIndex node, const Eigen::Vector3d& force, const Eigen::Vector3d& moment) {
                 sum -= half_ * power(kinematics, node, force, moment);
               });
  return sum;
}

void PairWork::add(const ContactKinematics& kinematics, const InterfaceConstraint& constraint,
                   const CornerForces& forces) {
  for (std::size_t k = 0; k < 8; ++k) {
    const Eigen::Vector3d force = forces.forces.col(static_cast<Eigen::Index>(k));
    if (!force.isZero(0.0))
      add(kinematics, {constraint.pair, constraint.nodes[k], force, Eigen::Vector3d::Zero()});
  }
}

void PairWork::archive(StateArchive& saved) {
  saved.fixed("contact/pairs/taken", std::span(taken_));
  saved.fixed("contact/pairs/coming", std::span(coming_));
  saved.rows("contact/pairs/forces", forces_,
             [](NodeForce& f, RowNumbers& row) { row(f.pair.value, f.node, f.force, f.moment); });
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/force_projection.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace contactsim {

namespace {

/// The share of a slip held by friction that comes back in a step.
constexpr double slip_recovery = 0.1;

}  // namespace

/// The normal force that closes the gap: < 0 where the sides part.
double ForceProjection::normal_force(const NodeVector& normal, const ConstraintRow& row,
                                     const NodeVector& changed) const {
  const double now = normal.dot(row.ahead), rate = (1.0 - constraint_compliance) / row.softness;
  const double gap = row.start + normal.dot(changed) + constraint_compliance * row.softness * now;
  return now - rate * gap;
}

/// The tangential force that would hold a point, before it is cut to the slip limit.
Eigen::Vector3d ForceProjection::trial_traction(const Eigen::Vector3d& normal, const ConstraintRow& row,
                                                const NodeVector& changed) const {
  const ConstraintFriction& friction = system_.frictions[*row.friction];
  const Eigen::Vector3d slip =
      slip_recovery * friction.held + friction.slip + in_plane(changed.head<3>(), normal);
  return in_plane(row.ahead.head<3>(), normal) - (1.0 - constraint_compliance) / friction.softness * slip;
}

double ForceProjection::slip_limit(const ConstraintRow& row, const NodeVector& changed,
                                   double normal_force) const {
  const ConstraintFriction& friction = system_.frictions[*row.friction];
  normal_force = std::max(0.0, normal_force);
  if (friction.limit_per_force >= 0.0) return friction.limit_per_force * normal_force;
  ContactPoint point = system_.point_of(row);
  point.force = normal_force;
  point.slip = friction.slip + in_plane(changed.head<3>(), point.normal);
  return friction.rule->slip_limit(point, dt_);
}

/// On light carriers the cone is that of the normal force that the pass starts from: with that of the force
/// to be found there would be no potential, without which Newton's method need not converge.
NodeVector ForceProjection::next_force(const NodeVector& normal, const ConstraintRow& row,
                                       const NodeVector& changed) const {
  const double closing = normal_force(normal, row, changed);
  const double force = row.pulls ? closing : std::max(0.0, closing);
  if (!row.friction) return force * normal;
  Eigen::Vector3d tangential = trial_traction(normal.head<3>(), row, changed);
  const double limit = slip_limit(row, changed, row.light ? std::max(0.0, normal.dot(row.ahead)) : force),
               size = tangential.norm();
  if (size > limit) tangential *= limit / size;
  return force * normal + node_vector(tangential);
}

LightAnswer ForceProjection::answer(const NodeVector& group_normal, const ConstraintRow& row,
                                    const NodeVector& changed) const {
  const NodeVector force = next_force(group_normal, row, changed);
  const double rate = dt_ * (1.0 - constraint_compliance) / row.softness;
  LightAnswer answer{force.head<3>(), (force - row.ahead).head<3>(), Eigen::Matrix3d::Zero(), rate};
  const Eigen::Vector3d normal = group_normal.head<3>();
  if (row.pulls || normal_force(group_normal, row, changed) > 0.0)
    answer.rate = rate * normal * normal.transpose();
  if (!row.friction) return answer;
  const Eigen::Vector3d trial = trial_traction(normal, row, changed);
  constexpr double round_off = 1e-9;
  const double size = trial.norm(), held = in_plane(force.head<3>(), normal).norm();
  const Eigen::Matrix3d plane = Eigen::Matrix3d::Identity() - normal * normal.transpose();
  const double of_slip = dt_ * (1.0 - constraint_compliance) / system_.frictions[*row.friction].softness;
  if (held >= (1.0 - round_off) * size) {
    answer.rate += of_slip * plane;
  } else if (size > 0.0) {
    const Eigen::Vector3d direction = trial / size;
    answer.rate += of_slip * held / size * (plane - direction * direction.transpose());
  }
  return answer;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/constraint_losses.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "contact/enforcement/force_projection.hpp"
#include "contact/enforcement/relative_velocity.hpp"

namespace contactsim {

namespace {

/// What passes leave of a penetration, because a light part between heavier ones answers to each a little
/// only, is made up for in the next step; at most by this share of what the force of the point itself closes:
/// more would throw apart what folds hold in.
constexpr double max_recovery = 0.1;

bool has_force(const ConstraintRow& row, double force) { return row.pulls ? force != 0.0 : force > 0.0; }

/// What the next step is to know of a row that has no force, if anything: the gap at which it touches.
ContactHistory::Entry entry_without_force(const ConstraintRow& row, const ContactPoint& point) {
  ContactHistory::Entry begun;
  if (!(row.zero_gap < 0.0)) return begun;
  begun.area = point.area;
  begun.zero_gap = row.zero_gap;
  return begun;
}

}  // namespace

/// What a force loses in half of the step before. The leapfrog begins mirrored at the first step.
///   before   motion of the first side along the second in the step before [length]
///   changed  by which all forces change that of the coming step [length]
double ConstraintLosses::lost_before(const Eigen::Vector3d& force, const ContactPoint& point,
                                     const Eigen::Vector3d& before, const Eigen::Vector3d& changed) const {
  if (!is_first_step) return -0.5 * force.dot(before);
  const Eigen::Vector3d added =
      relative_velocity(kinematics, point, false) - relative_velocity(kinematics, point, true);
  return 0.25 * force.dot(2.0 * dt * added + changed);
}

/// The part of finish() that is friction's.
///   before  as of lost_before
void ConstraintLosses::finish_friction(const ConstraintRow& row, double force, const NodeVector& change,
                                       const Eigen::Vector3d& before, ContactHistory::Entry& entry,
                                       ContactLoss& loss) const {
  ContactPoint& point = system.points[row.point];
  const ConstraintFriction& friction = system.frictions[*row.friction];
  const Eigen::Vector3d changed = change.head<3>();
  const Eigen::Vector3d slip = friction.slip + in_plane(changed, point.normal);
  const Eigen::Vector3d tangential = in_plane(row.force.head<3>(), point.normal);
  const double friction_before = lost_before(tangential, point, before, changed),
               friction_after = -0.5 * tangential.dot(slip);
  loss.friction_before += friction_before;
  loss.friction_after += friction_after;
  point.dissipated = friction_before + friction_after;
  point.work_before += friction_before;
  point.work_after += friction_after;
  point.tangential += tangential;
  const double limit = ForceProjection(system, dt).slip_limit(row, change, force);
  const bool slides = tangential.norm() >= (1.0 - 1e-9) * limit;
  if (slides) point.slip = slip;
  point.elastic_slip = slides ? Eigen::Vector3d::Zero() : Eigen::Vector3d(friction.held + slip);
  entry.traction = tangential / point.area;
  entry.held = point.elastic_slip;
}

/// The part of finish() that is the normal force's.
ContactHistory::Entry ConstraintLosses::finish_normal(const ConstraintRow& row, double force,
                                                      double impact_before, double opened,
                                                      ContactLoss& loss) const {
  ContactPoint& point = system.points[row.point];
  const double impact_after = 0.5 * force * (point.closing - opened);
  loss.impact_before += impact_before;
  loss.impact_after += impact_after;
  point.impact = impact_before + impact_after;
  point.knows_work = !point.touches();
  point.work_before = impact_before;
  point.work_after = impact_after;
  point.force += force;
  ContactHistory::Entry entry{force / point.area};
  const double left = -(row.start + opened);
  entry.area = point.area;
  entry.zero_gap = row.zero_gap;
  entry.left = std::clamp(left, 0.0, std::max(0.0, max_recovery * force * row.softness));
  return entry;
}

ContactHistory::Entry ConstraintLosses::finish(const ConstraintRow& row, double force,
                                               const NodeVector& change, ContactLoss& loss) const {
  const ContactPoint& point = system.point_of(row);
  if (!has_force(row, force)) return entry_without_force(row, point);
  const Eigen::Vector3d before = dt_before * relative_velocity(kinematics, point, true),
                        changed = change.head<3>();
  const double impact_before = lost_before(force * point.normal, point, before, changed);
  ContactHistory::Entry entry = finish_normal(row, force, impact_before, point.normal.dot(changed), loss);
  if (row.friction) finish_friction(row, force, change, before, entry, loss);
  return entry;
}

ContactHistory::Entry ConstraintLosses::finish_pressing(const ConstraintRow& row, double force,
                                                        double opened_before, double opened,
                                                        ContactLoss& loss) const {
  const ContactPoint& point = system.point_of(row);
  if (!has_force(row, force)) return entry_without_force(row, point);
  const double impact_before =
      is_first_step ? lost_before(force * point.normal, point, Eigen::Vector3d::Zero(), opened * point.normal)
                    : -0.5 * force * opened_before;
  return finish_normal(row, force, impact_before, opened, loss);
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/friction.hpp"

#include <cmath>

namespace contactsim {

namespace {

/// The part of a vector in the plane, its length kept: contact that rolls over an edge loses no force.
Eigen::Vector3d turned_into_plane(const Eigen::Vector3d& vector, const Eigen::Vector3d& normal) {
  const double length_squared = vector.squaredNorm();
  const Eigen::Vector3d flat = vector - normal.dot(vector) * normal;
  const double flat_squared = flat.squaredNorm();
  return flat_squared > 0.0 ? Eigen::Vector3d(std::sqrt(length_squared / flat_squared) * flat) : flat;
}

}  // namespace

FrictionStep step_friction(const Eigen::Vector3d& normal, const Eigen::Vector3d& elastic,
                           const Eigen::Vector3d& slip, double stiffness, double limit) {
  FrictionStep step;
  const Eigen::Vector3d along = slip - normal.dot(slip) * normal;
  step.elastic = turned_into_plane(elastic, normal) + along;
  const double length = step.elastic.norm();
  if (stiffness * length > limit) {
    const double held = limit / stiffness;
    step.slip = (1.0 - held / length) * step.elastic;
    step.elastic -= step.slip;
    step.dissipated = limit * step.slip.norm();
  }
  step.force = -stiffness * step.elastic;
  return step;
}

void add_friction(double stiffness, double limit, ContactRecord& record) {
  const FrictionStep step = step_friction(record.normal, record.elastic, record.slip, stiffness, limit);
  record.tangential = step.force;
  record.elastic = step.elastic;
  record.slip = step.slip;
  record.dissipated = step.dissipated;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/friction.hpp"

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

FrictionStep step_friction(const Eigen::Vector3d& normal, const Eigen::Vector3d& elastic_slip,
                           const Eigen::Vector3d& slip, double stiffness, double limit) {
  FrictionStep step;
  const Eigen::Vector3d along = slip - normal.dot(slip) * normal;
  step.elastic_slip = turned_into_plane(elastic_slip, normal) + along;
  const double length = step.elastic_slip.norm();
  if (stiffness * length > limit) {
    const double held = limit / stiffness;
    step.slip = (1.0 - held / length) * step.elastic_slip;
    step.elastic_slip -= step.slip;
    step.dissipated = limit * step.slip.norm();
  }
  step.force = -stiffness * step.elastic_slip;
  return step;
}

void add_friction(double stiffness, double limit, ContactPoint& point) {
  const FrictionStep step = step_friction(point.normal, point.elastic_slip, point.slip, stiffness, limit);
  point.tangential = step.force;
  point.elastic_slip = step.elastic_slip;
  point.slip = step.slip;
  point.dissipated = step.dissipated;
}

}  // namespace contactsim

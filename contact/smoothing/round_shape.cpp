// SPDX-License-Identifier: BSD-3-Clause
#include "contact/smoothing/round_shape.hpp"

namespace contactsim {

namespace {

/// A unit vector and its derivatives. The vector must not be zero.
FaceVector unit_of(const FaceVector& v) {
  const double length = v.value.norm();
  const Eigen::Vector3d unit = v.value / length;
  const auto derivative = [&](const Eigen::Vector3d& d) -> Eigen::Vector3d {
    return (d - unit.dot(d) * unit) / length;
  };
  return {unit, derivative(v.by_xi), derivative(v.by_eta)};
}

}  // namespace

Eigen::Vector3d RoundShape::way_to(const Eigen::Vector3d& x) const {
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  return way_to(FaceVector{x, none, none}).value;
}

FaceVector RoundShape::way_to(const FaceVector& x) const {
  FaceVector way{x.value - origin, x.by_xi, x.by_eta};
  if (kind == Kind::spherical) return way;
  const auto off_axis = [this](Eigen::Vector3d v) -> Eigen::Vector3d { return v - axis.dot(v) * axis; };
  const FaceVector radial{off_axis(way.value), off_axis(way.by_xi), off_axis(way.by_eta)};
  if (kind == Kind::circumferential || radial.value.isZero(0.0)) return radial;
  const FaceVector towards = unit_of(radial);
  way.value -= arc_radius * towards.value;
  way.by_xi -= arc_radius * towards.by_xi;
  way.by_eta -= arc_radius * towards.by_eta;
  return way;
}

}  // namespace contactsim

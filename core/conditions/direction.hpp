// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <span>
#include <variant>

#include "core/conditions/condition_scope.hpp"
#include "core/definition/condition_lines.hpp"

namespace contactsim {

/// Some of the global axes.
struct Components {
  std::array<bool, 3> is_set{};
};

/// A straight line that things turn about, counter-clockwise when its direction points to the viewer.
struct Axis {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();       ///< on it [length]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< unit [1]

  /// The way from the axis to a position, at right angles to it [length].
  Eigen::Vector3d offset_of(const Eigen::Vector3d& position) const {
    const Eigen::Vector3d from_point = position - point;
    return from_point - from_point.dot(direction) * direction;
  }

  /// What turning by an angle adds to an offset [length]; exact for small angles too.
  ///   sine, cosine_less_one  of the angle [1]
  Eigen::Vector3d turn(const Eigen::Vector3d& offset, double sine, double cosine_less_one) const {
    return cosine_less_one * offset + sine * direction.cross(offset);
  }
};

/// Which way a condition acts: each of some global axes, a unit vector, or about an axis.
using Direction = std::variant<Components, Eigen::Vector3d, Axis>;

/// Looks up what a choice names. Errors: names that are not defined, an axis through one point.
std::optional<Direction> find_direction(const DirectionChoice& choice, const ConditionScope& scope);

/// The unit vectors of the directions that are not an axis. Precondition: it is none.
std::vector<Eigen::Vector3d> unit_vectors(const Direction& direction);

/// The sum of the unit vectors: what a value along the direction stands for. Precondition: it is no axis.
Eigen::Vector3d sum_of_units(const Direction& direction);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "core/base/names.hpp"

namespace contactsim {

/// DEFINE POINT <name> WITH COORDINATES <x> <y> <z>.
struct PointDefinition {
  DeckName name;
  Eigen::Vector3d coordinates = Eigen::Vector3d::Zero();  ///< [length]
};

/// DEFINE DIRECTION <name> WITH VECTOR <x> <y> <z>.
struct DirectionDefinition {
  DeckName name;
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();  ///< as the deck gives it, not zero; any length [1]
};

/// DEFINE AXIS <name> WITH POINT <p> DIRECTION <d>, or WITH POINT <p> POINT <q>. Exactly one of `direction`
/// and `second_point` is there.
struct AxisDefinition {
  DeckName name;
  DeckName point;
  std::optional<DeckName> direction;
  std::optional<DeckName> second_point;  ///< the axis runs from `point` to it
};

enum class CoordinateSystemKind : std::uint8_t { rectangular, cylindrical, spherical };

/// DEFINE COORDINATE SYSTEM <name> <kind> WITH POINT <origin> POINT <on z> POINT <in xz plane>.
struct CoordinateSystemDefinition {
  DeckName name;
  CoordinateSystemKind kind = CoordinateSystemKind::rectangular;
  DeckName origin, point_on_z, point_in_xz;
};

}  // namespace contactsim

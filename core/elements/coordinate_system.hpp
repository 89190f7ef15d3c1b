// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/base/diagnostics.hpp"
#include "core/definition/declarations.hpp"
#include "core/definition/geometry.hpp"

namespace contactsim {

/// A coordinate system of the deck.
struct CoordinateSystem {
  CoordinateSystemKind kind = CoordinateSystemKind::rectangular;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();    ///< [length]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns: unit x, y, z

  /// Columns: the unit directions at a place, x y z of rectangular systems; of cylindrical ones away from the
  /// axis, around it and along it, on it x y z.
  Eigen::Matrix3d directions_at(const Eigen::Vector3d& place) const;
};

/// The system with the name. Nothing when an error was added: the name or one of its points is not defined,
/// its points lie on one line, it is spherical. Source: Sierra/SM, DEFINE COORDINATE SYSTEM.
std::optional<CoordinateSystem> find_coordinate_system(const DeckName& name,
                                                       const SimulationDefinition& definition,
                                                       Diagnostics& diagnostics);

}  // namespace contactsim

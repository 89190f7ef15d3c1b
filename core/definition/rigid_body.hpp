// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/names.hpp"

namespace contactsim {

/// POINT MASS = <m> AT LOCATION <x> <y> <z>.
struct AttachedPointMass {
  double mass = 0.0;                                   ///< >= 0 [mass]
  Eigen::Vector3d location = Eigen::Vector3d::Zero();  ///< [length]
};

/// BEGIN RIGID BODY <name>. What is absent follows from the member blocks.
struct RigidBodyDefinition {
  DeckName name;
  std::optional<Eigen::Vector3d> reference_location;  ///< absent: the centre of mass [length]
  std::vector<DeckName> node_sets;                    ///< whose nodes belong to the body
  std::optional<double> mass;                         ///< > 0 [mass]
  std::optional<std::array<double, 6>> inertia;  ///< xx yy zz xy yz zx about the reference [mass length^2]
  std::vector<AttachedPointMass> point_masses;
  double magnitude = std::numeric_limits<double>::quiet_NaN();  ///< of the initial velocity [length/time]
  std::optional<DeckName> direction;                            ///< of the initial velocity
  double angular_velocity = std::numeric_limits<double>::quiet_NaN();  ///< at the start [1/time]
  std::optional<DeckName> cylindrical_axis;                            ///< about which it turns at the start
};

}  // namespace contactsim

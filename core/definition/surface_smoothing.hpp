// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "core/base/names.hpp"

namespace contactsim {

/// A point of a line: one that DEFINE POINT names, or its coordinates [length].
using PointReference = std::variant<DeckName, Eigen::Vector3d>;

/// An axis of a line: through two points, or one that DEFINE AXIS names.
struct AxisReference {
  std::optional<DeckName> axis;
  std::optional<std::array<PointReference, 2>> points;  ///< exactly one of both is there
};

/// CIRCUMFERENTIAL AXIS: a part of a surface of revolution about an axis.
struct CircumferentialShape {
  AxisReference axis;
};

/// SPHERICAL CENTER: a part of a sphere.
struct SphericalShape {
  PointReference center;
};

/// TOROIDAL AXIS <axis> RADIUS <r>: a part of a torus, a circular arc turned about an axis. The first point
/// of the axis is the middle of the circle on which the centres of the arc lie.
struct ToroidalShape {
  AxisReference axis;
  double radius = 0.0;  ///< of that circle, > 0 [length]
};

/// Contact surfaces that are parts of one round shape.
struct SmoothingRegion {
  DeckLocation location;
  std::vector<DeckName> surfaces;  ///< contact surfaces; ALL stands for every one
  std::optional<std::variant<CircumferentialShape, SphericalShape, ToroidalShape>> shape;
};

/// BEGIN SURFACE SMOOTHING <name>: the round shapes that surfaces of faces stand for. Source: *SURFACE
/// SMOOTHING of Abaqus, SMOOTH of OptiStruct's CONTACT.
struct SurfaceSmoothing {
  DeckName name;
  std::vector<SmoothingRegion> regions;
};

/// SMOOTHING = OFF, AUTO or a name: by which round shapes a pair counts its gaps.
struct SmoothingChoice {
  enum class Kind : std::uint8_t { off, automatic, named };

  Kind kind = Kind::off;
  DeckName name;  ///< of the line's word
};

}  // namespace contactsim

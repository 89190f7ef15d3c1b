// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/coordinate_system.hpp"

#include <Eigen/Geometry>

#include <fmt/format.h>

#include "core/base/find_definition.hpp"
#include "core/definition/simulation.hpp"

namespace contactsim {

Eigen::Matrix3d CoordinateSystem::directions_at(const Eigen::Vector3d& place) const {
  if (kind == CoordinateSystemKind::rectangular) return axes;
  const Eigen::Vector3d way = place - origin, along = axes.col(2);
  const Eigen::Vector3d out = way - way.dot(along) * along;
  constexpr double tolerance = 1e-9;  // of the way
  if (out.norm() <= tolerance * way.norm()) return axes;
  Eigen::Matrix3d directions;
  directions.col(0) = out.normalized();
  directions.col(1) = along.cross(directions.col(0));
  directions.col(2) = along;
  return directions;
}

std::optional<CoordinateSystem> find_coordinate_system(const DeckName& name,
                                                       const SimulationDefinition& definition,
                                                       Diagnostics& diagnostics) {
  const auto* found = find_definition(definition.coordinate_systems, name, "coordinate system", diagnostics);
  if (found == nullptr) return std::nullopt;
  const auto* origin = find_definition(definition.points, found->origin, "point", diagnostics);
  const auto* on_z = find_definition(definition.points, found->point_on_z, "point", diagnostics);
  const auto* in_xz = find_definition(definition.points, found->point_in_xz, "point", diagnostics);
  if (origin == nullptr || on_z == nullptr || in_xz == nullptr) return std::nullopt;
  const auto fail = [&](std::string text) {
    diagnostics.add_error(found->name.location, std::move(text), "",
                          static_cast<int>(found->name.text.size()));
    return std::nullopt;
  };
  if (found->kind == CoordinateSystemKind::spherical)
    return fail(fmt::format("the spherical system '{}' cannot give directions of a material", name.text));
  const Eigen::Vector3d z = (on_z->coordinates - origin->coordinates).stableNormalized();
  const Eigen::Vector3d towards = (in_xz->coordinates - origin->coordinates).stableNormalized();
  const Eigen::Vector3d y = z.cross(towards);
  constexpr double tolerance = 1e-9;  // sine of the angle between the two ways
  if (!(y.norm() > tolerance))
    return fail(fmt::format("the three points of the coordinate system '{}' lie on one line", name.text));
  CoordinateSystem system{found->kind, origin->coordinates, {}};
  system.axes.col(1) = y.normalized();
  system.axes.col(2) = z;
  system.axes.col(0) = system.axes.col(1).cross(z);
  return system;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/smoothing_report.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/reports/number.hpp"
#include "app/reports/text_table.hpp"
#include "core/base/pluralize.hpp"

namespace contactsim {

namespace {

std::string describe_place(const RoundShape& shape) {
  const auto vector = [](Eigen::Vector3d v) {
    v = (v.array().abs() > 1e-9 * v.norm()).select(v, 0.0);  // round-off tells nothing
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x(), v.y(), v.z());
  };
  switch (shape.kind) {
    case RoundShape::Kind::spherical:
      return "about " + vector(shape.origin);
    case RoundShape::Kind::circumferential:
      return "axis " + vector(shape.axis) + " through " + vector(shape.origin);
    default:
      return fmt::format("axis {} through {}, circle of {:.6g}", vector(shape.axis), vector(shape.origin),
                         shape.arc_radius);
  }
}

std::string describe_unfitted(const SurfaceShapes& shapes) {
  const std::string parts = pluralize(shapes.n_unfitted, "part");
  if (!std::isfinite(shapes.least_residual)) return parts + " not round";
  return fmt::format("{} not round, by {:.3g} of the radius at least", parts, shapes.least_residual);
}

void add_shapes(const std::string& smoothing, const std::string& surface, const SurfaceShapes& shapes,
                TextTable& table) {
  static constexpr std::array kinds{"circumferential", "spherical", "toroidal"};
  const auto kind_of = [](const RoundShape& shape) { return kinds[static_cast<std::size_t>(shape.kind)]; };
  for (const RoundShape& shape : shapes.given)
    table.add(smoothing, surface, kind_of(shape), "-", "of nodes", "-", describe_place(shape));
  for (const FittedShape& fitted : shapes.fitted)
    table.add(smoothing, surface, kind_of(fitted.shape), fitted.n_faces, number(fitted.radius),
              number(fitted.residual), describe_place(fitted.shape));
  if (shapes.n_unfitted > 0) table.add(smoothing, surface, "none", "-", "-", "-", describe_unfitted(shapes));
  if (shapes.n_flat > 0 && shapes.fitted.empty())
    table.add(smoothing, surface, "flat", "-", "-", "-", pluralize(shapes.n_flat, "flat part"));
}

}  // namespace

std::string format_smoothings(const ContactModel& model) {
  TextTable table(6, 3,
                  {name_column("smoothing", 16),
                   name_column("surface", 20),
                   name_column("shape", 15),
                   {"faces", 8},
                   {"radius", 11},
                   {"residual", 11},
                   text_column("where")});
  for (const SmoothingShapes& smoothing : model.smoothings) {
    for (const SurfaceIndex i : indices(smoothing.surfaces))
      add_shapes(smoothing.name, model.surfaces.surfaces[i].name, smoothing.surfaces[i], table);
  }
  return table.empty() ? "" : "\nRound shapes of surfaces\n" + table.format();
}

}  // namespace contactsim

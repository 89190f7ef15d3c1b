// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/smoothing_report.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/reports/number.hpp"
#include "core/base/pluralize.hpp"

namespace contactsim {

namespace {

constexpr const char* smoothings_format = "      {:<22} {:<28} {:<15} {:>9} {:>11} {:>11}  {}\n";

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

std::string format_shapes(const SmoothingShapes& smoothing, const std::string& surface,
                          const SurfaceShapes& shapes) {
  static constexpr std::array kinds{"circumferential", "spherical", "toroidal"};
  const auto kind_of = [](const RoundShape& shape) { return kinds[static_cast<std::size_t>(shape.kind)]; };
  std::string text;
  for (const RoundShape& shape : shapes.given)
    text += fmt::format(smoothings_format, smoothing.name, surface, kind_of(shape), "-", "of nodes", "-",
                        describe_place(shape));
  for (const FittedShape& fitted : shapes.fitted)
    text += fmt::format(smoothings_format, smoothing.name, surface, kind_of(fitted.shape), fitted.n_faces,
                        number(fitted.radius), number(fitted.residual), describe_place(fitted.shape));
  if (shapes.n_unfitted > 0)
    text +=
        fmt::format(smoothings_format, smoothing.name, surface, "none", "-", "-", "-",
                    fmt::format("{} not round{}", pluralize(shapes.n_unfitted, "part"),
                                std::isfinite(shapes.least_residual)
                                    ? fmt::format(", by {:.3g} of the radius at least", shapes.least_residual)
                                    : ""));
  if (shapes.n_flat > 0 && shapes.fitted.empty())
    text += fmt::format(smoothings_format, smoothing.name, surface, "flat", "-", "-", "-",
                        pluralize(shapes.n_flat, "flat part"));
  return text;
}

}  // namespace

std::string format_smoothings(const ContactModel& model) {
  std::string text;
  for (const SmoothingShapes& smoothing : model.smoothings) {
    for (const SurfaceIndex i : indices(smoothing.surfaces))
      text += format_shapes(smoothing, model.surfaces.surfaces[i].name, smoothing.surfaces[i]);
  }
  if (text.empty()) return "";
  return "\nRound shapes of surfaces\n" +
         fmt::format(smoothings_format, "smoothing", "surface", "shape", "faces", "radius", "residual",
                     "where") +
         text;
}

}  // namespace contactsim

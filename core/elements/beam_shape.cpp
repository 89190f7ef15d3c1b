// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/beam_shape.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace contactsim {

namespace {

/// Adds a rectangle by 3 x 3 Gauss points, which are exact for its second moments.
void add_rectangle(double t, double s, double width, double height, BeamShapeSettings& shape) {
  constexpr std::array<double, 3> places{-0.7745966692414834, 0.0, 0.7745966692414834};
  constexpr std::array<double, 3> weights{5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      shape.fibres.push_back({t + 0.5 * width * places[i], s + 0.5 * height * places[j],
                              weights[i] * weights[j] * width * height});
    }
  }
}

/// Two rings of eight points, at the Gauss points of the squared radius: with r dr = d(r^2) / 2 powers of the
/// radius up to r^6 are exact, area and second moments among them.
void add_annulus(double inner, double outer, BeamShapeSettings& shape) {
  constexpr int n = 8;
  const double middle = 0.5 * (inner * inner + outer * outer), half = 0.5 * (outer * outer - inner * inner);
  for (const double side : {-1.0, 1.0}) {
    const double radius = std::sqrt(middle + side * half / std::sqrt(3.0));
    for (int i = 0; i < n; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + 0.5) / n;
      shape.fibres.push_back(
          {radius * std::cos(angle), radius * std::sin(angle), std::numbers::pi * half / n});
    }
  }
}

/// J = pi d^4 / 32. The shares of the area that resist shear are Cowper's of Poisson's ratio 0, here and
/// below: 6 / 7 of a circle, 1 / 2 of a thin tube, 5 / 6 of a rectangle.
void add_rod(double width, BeamShapeSettings& shape) {
  add_annulus(0.0, 0.5 * width, shape);
  shape.torsion = std::numbers::pi * std::pow(width, 4) / 32.0;
  shape.shear_t = shape.shear_s = 6.0 / 7.0;
}

/// J = pi (R^4 - r^4) / 2.
void add_tube(double width, double wall, BeamShapeSettings& shape) {
  const double outer = 0.5 * width, inner = outer - wall;
  add_annulus(inner, outer, shape);
  shape.torsion = 0.5 * std::numbers::pi * (std::pow(outer, 4) - std::pow(inner, 4));
  shape.shear_t = shape.shear_s = 0.5;
}

/// Edges a >= b: J = a b^3 (1/3 - 0.21 b/a (1 - b^4 / (12 a^4))). Source: Roark, table 10.1, whose a and b
/// are half of these.
void add_bar(double width, double height, BeamShapeSettings& shape) {
  add_rectangle(0.0, 0.0, width, height, shape);
  const double a = std::max(width, height), b = std::min(width, height), r = b / a;
  shape.torsion = a * b * b * b * (1.0 / 3.0 - 0.21 * r * (1.0 - r * r * r * r / 12.0));
  shape.shear_t = shape.shear_s = 5.0 / 6.0;
}

/// Closed and thin-walled: J = 4 A^2 t / s by the area A inside the walls' middle line and its length s
/// (Bredt). Walls along a direction resist the shear along it.
void add_box(double width, double height, double wall, BeamShapeSettings& shape) {
  const double across_t = 0.5 * (width - wall), across_s = 0.5 * (height - wall);
  for (const double side : {-1.0, 1.0}) {
    add_rectangle(side * across_t, 0.0, wall, height - 2.0 * wall, shape);
    add_rectangle(0.0, side * across_s, width, wall, shape);
  }
  const double enclosed = 4.0 * across_t * across_s, around = 4.0 * (across_t + across_s);
  shape.torsion = 4.0 * enclosed * enclosed * wall / around;
  const double area = around * wall;
  shape.shear_t = 2.0 * width * wall / area;
  shape.shear_s = 2.0 * height * wall / area;
}

/// Flanges along t, the web along s. Open and thin-walled: J is the sum of length x thickness^3 / 3. Flanges
/// resist shear along t, as rectangles, the web and its ends in them that along s.
void add_i(double width, double height, double web, double flange, BeamShapeSettings& shape) {
  const double inside = height - 2.0 * flange;
  add_rectangle(0.0, 0.0, web, inside, shape);
  for (const double side : {-1.0, 1.0})
    add_rectangle(0.0, side * 0.5 * (height - flange), width, flange, shape);
  shape.torsion = (2.0 * width * std::pow(flange, 3) + inside * std::pow(web, 3)) / 3.0;
  const double area = 2.0 * width * flange + inside * web;
  shape.shear_t = 5.0 / 6.0 * 2.0 * width * flange / area;
  shape.shear_s = height * web / area;
}

/// Whether sizes and walls are there and fit; else says what is wrong.
bool check(const BeamSection& section, std::string& problem) {
  const bool is_round = section.shape == BeamShape::rod || section.shape == BeamShape::tube;
  const bool is_hollow = section.shape != BeamShape::rod && section.shape != BeamShape::bar;
  if (!section.width)
    problem = "WIDTH";
  else if (!is_round && !section.height)
    problem = "HEIGHT";
  else if (is_hollow && !section.wall_thickness)
    problem = "WALL THICKNESS";
  else if (section.shape == BeamShape::i && !section.flange_thickness)
    problem = "FLANGE THICKNESS";
  if (!problem.empty()) {
    problem = "needs " + problem;
    return false;
  }
  const double height = section.height.value_or(*section.width), wall = section.wall_thickness.value_or(0.0);
  const double flange = section.shape == BeamShape::i ? *section.flange_thickness : wall;
  if (wall < *section.width && 2.0 * flange < height &&
      (section.shape == BeamShape::i || 2.0 * wall < *section.width))
    return true;
  problem = "has walls that do not fit into it";
  return false;
}

/// Area and second moments are those of the fibres; then these are moved to where the nodes see them.
void complete(const BeamSection& section, BeamShapeSettings& shape) {
  for (BeamFibre& fibre : shape.fibres) {
    shape.area += fibre.area;
    shape.second_t += fibre.area * fibre.t * fibre.t;
    shape.second_s += fibre.area * fibre.s * fibre.s;
    fibre.t += section.axis_offset[0];
    fibre.s += section.axis_offset[1];
  }
  shape.is_offset = section.axis_offset[0] != 0.0 || section.axis_offset[1] != 0.0;
  if (section.t_axis) shape.t_axis = *section.t_axis;
}

}  // namespace

std::optional<BeamShapeSettings> make_beam_shape(const BeamSection& section, std::string& problem) {
  BeamShapeSettings shape;
  if (!check(section, problem)) return std::nullopt;
  const double width = *section.width, height = section.height.value_or(width);
  const double wall = section.wall_thickness.value_or(0.0);
  switch (section.shape) {
    case BeamShape::rod:
      add_rod(width, shape);
      break;
    case BeamShape::tube:
      add_tube(width, wall, shape);
      break;
    case BeamShape::bar:
      add_bar(width, height, shape);
      break;
    case BeamShape::box:
      add_box(width, height, wall, shape);
      break;
    case BeamShape::i:
      add_i(width, height, wall, *section.flange_thickness, shape);
      break;
  }
  complete(section, shape);
  return shape;
}

}  // namespace contactsim

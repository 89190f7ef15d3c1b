// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "support/lone_element.hpp"
#include "support/lone_shell.hpp"

/// Beams and trusses of two nodes. Moduli are near 1e11, lengths near 1, steps of size 1.
namespace contactsim::test {

inline constexpr ElasticModuli line_steel{160e9, 80e9};
inline constexpr double line_youngs = 9.0 * 160e9 * 80e9 / (3.0 * 160e9 + 80e9);
inline constexpr double size_of_line_forces = 1e9;  // modulus x area

inline MaterialLaw line_elastic() { return ElasticLaw{line_steel}; }

inline BeamShapeSettings shape_of_beam(BeamShape kind, bool is_offset = false) {
  BeamSection section;
  section.shape = kind;
  section.width = 0.1;
  section.height = 0.2;
  section.wall_thickness = 0.01;
  section.flange_thickness = 0.02;
  section.t_axis = Eigen::Vector3d(0.3, 1.0, 0.2);
  if (is_offset) section.axis_offset = {0.05, -0.1};
  std::string problem;
  return *make_beam_shape(section, problem);
}

inline std::vector<BeamShapeSettings> all_beam_shapes() {
  std::vector<BeamShapeSettings> shapes;
  for (const BeamShape kind : {BeamShape::rod, BeamShape::tube, BeamShape::bar, BeamShape::box, BeamShape::i})
    shapes.push_back(shape_of_beam(kind));
  shapes.push_back(shape_of_beam(BeamShape::bar, true));
  return shapes;
}

/// Two nodes in no special direction.
inline Eigen::Matrix3Xd slanted_line(double length = 0.8) {
  Eigen::Matrix3Xd x(3, 2);
  x.col(0) = Eigen::Vector3d(0.1, 0.2, -0.3);
  x.col(1) = x.col(0) + length * Eigen::Vector3d(0.6, -0.5, 0.7).normalized();
  return x;
}

inline LoneShell beam_of(const BeamShapeSettings& shape, const Eigen::Matrix3Xd& x,
                         const MaterialLaw& law = line_elastic()) {
  const double area = shape.area;
  return {make_line_block(one_element_mesh(Shape::beam2, x), 0, beam2_beam, undamped(law), shape, {&area, 1}),
          x};
}

inline LoneShell truss_of(double area, const Eigen::Matrix3Xd& x, const MaterialLaw& law = line_elastic()) {
  BeamShapeSettings one_fibre;
  one_fibre.fibres = {{}};
  return {
      make_line_block(one_element_mesh(Shape::bar2, x), 0, bar2_truss, undamped(law), one_fibre, {&area, 1}),
      x};
}

}  // namespace contactsim::test

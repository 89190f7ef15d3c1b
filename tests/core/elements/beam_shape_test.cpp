// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/beam_shape.hpp"

#include <numbers>

#include "support/catch.hpp"

using namespace contactsim;
using std::numbers::pi;

namespace {

BeamSection section_of(BeamShape shape, double width, std::optional<double> height = {},
                       std::optional<double> wall = {}, std::optional<double> flange = {}) {
  BeamSection section;
  section.shape = shape;
  section.width = width;
  section.height = height;
  section.wall_thickness = wall;
  section.flange_thickness = flange;
  return section;
}

BeamShapeSettings made(const BeamSection& section) {
  std::string problem;
  const auto shape = make_beam_shape(section, problem);
  CHECK(problem == "");
  REQUIRE(shape);
  return *shape;
}

std::string problem_of(const BeamSection& section) {
  std::string problem;
  CHECK_FALSE(make_beam_shape(section, problem));
  return problem;
}

}  // namespace

TEST_CASE("a rod has the area and moments of a circle", "[core][beam_shape]") {
  const BeamShapeSettings rod = made(section_of(BeamShape::rod, 2.0));
  CHECK(rod.area == Approx(pi));
  CHECK(rod.second_t == Approx(pi / 4.0));
  CHECK(rod.second_s == Approx(pi / 4.0));
  CHECK(rod.torsion == Approx(pi / 2.0));
  CHECK(rod.shear_t == Approx(6.0 / 7.0));
}

TEST_CASE("a tube has those of two circles", "[core][beam_shape]") {
  const BeamShapeSettings tube = made(section_of(BeamShape::tube, 4.0, {}, 1.0));  // radii 1 and 2
  CHECK(tube.area == Approx(3.0 * pi));
  CHECK(tube.second_t == Approx(15.0 * pi / 4.0));
  CHECK(tube.torsion == Approx(15.0 * pi / 2.0));
}

TEST_CASE("a bar has those of a rectangle", "[core][beam_shape]") {
  const BeamShapeSettings bar = made(section_of(BeamShape::bar, 2.0, 3.0));
  CHECK(bar.area == Approx(6.0));
  CHECK(bar.second_t == Approx(3.0 * 8.0 / 12.0));
  CHECK(bar.second_s == Approx(2.0 * 27.0 / 12.0));
  // Saint-Venant's series of a square gives 0.140577 a^4, of edges 1 and 10 0.31233 a b^3.
  CHECK(made(section_of(BeamShape::bar, 1.0, 1.0)).torsion == Approx(0.140577).epsilon(3e-3));
  CHECK(made(section_of(BeamShape::bar, 1.0, 10.0)).torsion == Approx(3.1233).epsilon(3e-3));
  CHECK(made(section_of(BeamShape::bar, 10.0, 1.0)).torsion ==
        made(section_of(BeamShape::bar, 1.0, 10.0)).torsion);
}

TEST_CASE("a box has those of two rectangles, and Bredt's torsion", "[core][beam_shape]") {
  const BeamShapeSettings box = made(section_of(BeamShape::box, 4.0, 6.0, 1.0));  // hole of 2 x 4
  CHECK(box.area == Approx(24.0 - 8.0));
  CHECK(box.second_t == Approx((6.0 * 64.0 - 4.0 * 8.0) / 12.0));
  CHECK(box.second_s == Approx((4.0 * 216.0 - 2.0 * 64.0) / 12.0));
  // Middle lines of 3 x 5: 4 x 15^2 x 1 / 16.
  CHECK(box.torsion == Approx(56.25));
  CHECK(box.shear_t == Approx(8.0 / 16.0));
  CHECK(box.shear_s == Approx(12.0 / 16.0));
}

TEST_CASE("an I has flanges along t and a web along s", "[core][beam_shape]") {
  const BeamShapeSettings shape = made(section_of(BeamShape::i, 4.0, 8.0, 1.0, 2.0));
  CHECK(shape.area == Approx(2 * 8.0 + 4.0));
  CHECK(shape.second_t == Approx((2 * 2.0 * 64.0 + 4.0 * 1.0) / 12.0));
  CHECK(shape.second_s == Approx((4.0 * 512.0 - 3.0 * 64.0) / 12.0));
  CHECK(shape.torsion == Approx((2 * 4.0 * 8.0 + 4.0 * 1.0) / 3.0));
  CHECK(shape.shear_t == Approx(5.0 / 6.0 * 16.0 / 20.0));
  CHECK(shape.shear_s == Approx(8.0 / 20.0));
}

TEST_CASE("an offset moves the fibres and leaves the section", "[core][beam_shape]") {
  BeamSection section = section_of(BeamShape::bar, 2.0, 3.0);
  CHECK_FALSE(made(section).is_offset);
  section.axis_offset = {10.0, -1.0};
  const BeamShapeSettings bar = made(section);
  CHECK(bar.is_offset);
  CHECK(bar.second_t == Approx(2.0));
  double first_t = 0.0, first_s = 0.0;
  for (const BeamFibre& fibre : bar.fibres) {
    first_t += fibre.area * fibre.t;
    first_s += fibre.area * fibre.s;
  }
  CHECK(first_t == Approx(60.0));
  CHECK(first_s == Approx(-6.0));
}

TEST_CASE("sizes that lack, and walls that do not fit, are said", "[core][beam_shape]") {
  BeamSection empty;
  empty.shape = BeamShape::rod;
  CHECK(problem_of(empty) == "needs WIDTH");
  CHECK(problem_of(section_of(BeamShape::bar, 1.0)) == "needs HEIGHT");
  CHECK(problem_of(section_of(BeamShape::tube, 1.0)) == "needs WALL THICKNESS");
  CHECK(problem_of(section_of(BeamShape::i, 1.0, 1.0, 0.1)) == "needs FLANGE THICKNESS");
  CHECK(problem_of(section_of(BeamShape::tube, 1.0, {}, 0.5)) == "has walls that do not fit into it");
  CHECK(problem_of(section_of(BeamShape::box, 4.0, 2.0, 1.0)) == "has walls that do not fit into it");
  CHECK(problem_of(section_of(BeamShape::i, 4.0, 2.0, 0.5, 1.0)) == "has walls that do not fit into it");
}

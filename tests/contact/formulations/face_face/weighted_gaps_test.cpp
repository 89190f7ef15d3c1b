// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/face_face/weighted_gaps.hpp"

#include "contact/formulations/slip_pressures.hpp"
#include "support/catch.hpp"
#include "support/contact_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

const std::string rough_pair =
    "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 0.2\n";

/// Overlaps of the bottom of a cube, whose nodes weigh, with what is below it.
struct WeighedCube {
  ContactParts parts;
  FaceIndex bottom, top;
  WeightedGaps gaps{IndexedVector<PairIndex, SurfaceIndex>{SurfaceIndex{1}}};
  ContactMultipliers multipliers;
  HeldSlips held;

  explicit WeighedCube(const std::string& more = "")
      : parts(cube_over_cube(0.0), general_contact(more)),
        bottom(face_of(parts, 1, -Vector3d::UnitZ())),
        top(face_of(parts, 0, Vector3d::UnitZ())) {}
  /// An overlap that one corner has a share of.
  WeightedOverlap overlap(std::size_t candidate, double area, double gap, double per_area = 100.0) const {
    WeightedOverlap made;
    made.first = bottom;
    made.second = top;
    made.candidate = candidate;
    made.rule = &parts.rules[{0}];
    made.penalty.stiffness = per_area;
    OverlapShare share{};
    share.area = area;
    share.part = 2;
    share.normal = Vector3d::UnitZ();
    made.shares.add(share);
    made.gaps[0] = gap;
    made.slopes[0] = 1.0;
    for (std::size_t k = 0; k < 4; ++k) {
      made.slips[k].setZero();
      made.held_slips[k].setZero();
    }
    return made;
  }
  void add(WeightedOverlap made) { gaps.add(parts.contact_mesh, std::move(made)); }
  const WeightedNode& found(double dt = 0.1) {
    ContactStepContext context = parts.context(dt);
    context.is_static = true;
    context.multipliers = &multipliers;
    context.held_slips = &held;
    gaps.find_tractions(context);
    return gaps.nodes()[0];
  }
};

}  // namespace

TEST_CASE("the gap and the stiffness of a node are means over its overlaps by area",
          "[contact][weighted_gaps]") {
  WeighedCube cube;
  cube.add(cube.overlap(0, 0.1, -0.02, 100.0));
  cube.add(cube.overlap(1, 0.3, 0.01, 300.0));
  REQUIRE(cube.gaps.nodes().size() == 1);
  const WeightedNode& node = cube.found();
  CHECK(node.row == *cube.parts.contact_mesh.find_row(cube.parts.contact_mesh.faces[cube.bottom].corners[2],
                                                      SurfaceIndex{1}));
  CHECK(node.area == Approx(0.4));
  CHECK(node.gap == Approx(0.25 * -0.02 + 0.75 * 0.01));
  CHECK(node.penalty.stiffness == Approx(250.0));
  CHECK(node.pressure == 0.0);  // open in the mean
}

TEST_CASE("a node presses by its mean depth and multiplier", "[contact][weighted_gaps]") {
  WeighedCube cube;
  cube.add(cube.overlap(0, 0.1, -0.02));
  CHECK(cube.found().pressure == Approx(100.0 * 0.02));
  CHECK(cube.found().slope == Approx(100.0));
  cube.multipliers.set({{{0}, cube.gaps.nodes()[0].row, 0.05}});
  CHECK(cube.found().pressure == Approx(100.0 * 0.07));
  CHECK(cube.found().depth() == Approx(0.07));
}

TEST_CASE(
    "a node that is open has neither pressure nor stiffness, one that just lies on the other side has one",
    "[contact][weighted_gaps]") {
  WeighedCube open, lies;
  open.add(open.overlap(0, 0.25, 0.01));
  CHECK(open.found().pressure == 0.0);
  CHECK(open.found().slope == 0.0);
  lies.add(lies.overlap(0, 0.25, 1e-8));
  CHECK(lies.found().pressure == 0.0);
  CHECK(lies.found().slope == Approx(100.0));
}

TEST_CASE("an overlap that is about to be too far counts less", "[contact][weighted_gaps]") {
  WeighedCube cube;
  WeightedOverlap faint = cube.overlap(1, 0.3, -0.01);
  faint.weight = 0.5;
  cube.add(cube.overlap(0, 0.15, -0.02));
  cube.add(faint);
  CHECK(cube.found().area == Approx(0.3));
  CHECK(cube.found().gap == Approx(-0.015));
}

TEST_CASE("corners and pairs have nodes of their own", "[contact][weighted_gaps]") {
  WeighedCube cube;
  WeightedOverlap two = cube.overlap(0, 0.1, -0.02);
  OverlapShare other = two.shares.corners[0];
  other.part = 0;
  two.shares.add(other);
  two.gaps[1] = -0.04;
  two.slopes[1] = 1.0;
  cube.add(two);
  WeightedOverlap of_pair = cube.overlap(1, 0.1, -0.06);
  of_pair.pair = {1};
  cube.add(of_pair);
  REQUIRE(cube.gaps.nodes().size() == 3);
  CHECK(cube.gaps.nodes()[1].gap == -0.04);
  CHECK(cube.gaps.nodes()[2].row == cube.gaps.nodes()[0].row);
  CHECK(&cube.gaps.node_of(cube.gaps.overlaps()[0], 1) == &cube.gaps.nodes()[1]);
  CHECK(&cube.gaps.node_of(cube.gaps.overlaps()[1], 0) == &cube.gaps.nodes()[2]);
}

TEST_CASE("overlaps are found by their candidate, and forgotten all at once", "[contact][weighted_gaps]") {
  WeighedCube cube;
  cube.add(cube.overlap(2, 0.1, -0.02));
  cube.add(cube.overlap(5, 0.1, -0.03));
  CHECK(cube.gaps.find(2)->gaps[0] == -0.02);
  CHECK(cube.gaps.find(5)->gaps[0] == -0.03);
  CHECK(cube.gaps.find(3) == nullptr);
  CHECK(cube.gaps.find(6) == nullptr);
  cube.gaps.clear();
  CHECK(cube.gaps.find(2) == nullptr);
  CHECK(cube.gaps.nodes().empty());
  cube.add(cube.overlap(0, 0.2, -0.01));
  REQUIRE(cube.gaps.nodes().size() == 1);
  CHECK(cube.gaps.nodes()[0].area == 0.2);  // nothing is left of before
}

TEST_CASE("what sides that weigh feel has its sign, and bears by what touches", "[contact][weighted_gaps]") {
  WeighedCube cube;
  WeightedOverlap overlap = cube.overlap(0, 0.1, -0.02);
  CHECK(overlap.sign() == 1.0);
  overlap.is_of_first = false;
  CHECK(overlap.sign() == -1.0);
  overlap.weight = 0.5;
  overlap.slopes[0] = 0.25;
  CHECK(overlap.bearing_area(0) == Approx(0.0125));
}

TEST_CASE("friction of a node is that of its mean slip, up to the limit of its pressure",
          "[contact][weighted_gaps]") {
  WeighedCube cube(rough_pair);
  WeightedOverlap first = cube.overlap(0, 0.1, -0.02), second = cube.overlap(1, 0.3, -0.02);
  first.slips[0] << 0.004, 0, 1.0;  // along the normal it does not count
  second.slips[0] << 0.008, 0, 0;
  cube.add(first);
  cube.add(second);
  const WeightedNode& node = cube.found();
  CHECK(node.bearing == Approx(0.4));
  CHECK(node.normal.isApprox(Vector3d::UnitZ()));
  CHECK(node.has_friction());
  // A spring of a tenth of 100 along 0.007.
  CHECK(node.friction.force.isApprox(Vector3d(-0.07, 0, 0)));
  CHECK(node.friction_slope == Approx(0.2));
  WeighedCube slid(rough_pair);
  second.rule = &slid.parts.rules[{0}];
  second.slips[0] << 0.3, 0.4, 0;
  slid.add(second);
  CHECK(slid.found().friction.force.isApprox(-0.2 * 2.0 * Vector3d(0.6, 0.8, 0)));
}

TEST_CASE("slip that load steps have held goes before what pairs of faces held", "[contact][weighted_gaps]") {
  WeighedCube cube(rough_pair);
  WeightedOverlap overlap = cube.overlap(0, 0.1, -0.02);
  overlap.held_slips[0] << 0.002, 0, 0;
  cube.add(overlap);
  CHECK(cube.found().friction.force.isApprox(Vector3d(-0.02, 0, 0)));
  cube.held.set({{{0}, cube.gaps.nodes()[0].row, Vector3d(0, 0.003, 0)}});
  CHECK(cube.found().friction.force.isApprox(Vector3d(0, -0.03, 0)));
}

TEST_CASE("what is open in the mean does not bear, and has no friction", "[contact][weighted_gaps]") {
  WeighedCube cube(rough_pair);
  WeightedOverlap overlap = cube.overlap(0, 0.1, 0.02);
  overlap.slips[0] << 0.004, 0, 0;
  cube.add(overlap);
  CHECK_FALSE(cube.found().has_friction());
  WeighedCube flat(rough_pair);
  WeightedOverlap other = flat.overlap(0, 0.1, -0.02);
  other.slopes[0] = 0.0;
  flat.add(other);
  CHECK_FALSE(flat.found().has_friction());
}

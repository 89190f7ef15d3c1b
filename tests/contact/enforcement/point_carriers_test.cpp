// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/point_carriers.hpp"

#include "support/catch.hpp"
#include "support/two_cubes.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

constexpr double half_steps = 0.1;

/// The carriers of contact points between two cubes.
struct CarriedCubes {
  test::TwoCubes cubes;
  ModelFreeDirections free;
  NodeMobility mobility;
  PointCarriers carriers{mobility};
  State state;
  PointCarriers::Terms terms;
  PointCarriers::Weights weights{};

  void begin() {
    free.update(cubes.model, 0.0);
    state = cubes.state(half_steps);
    mobility.begin(cubes.model, free, cubes.parts.kinematics, state);
    carriers.begin();
  }
  LeaningAreas areas_of(const PointCarriers::Direction& direction, double area) const {
    LeaningAreas areas(mobility.n_carriers(), {0.0, 0.0});
    carriers.add_areas(terms, weights, direction, area, areas);
    return areas;
  }
  /// The change of the point's gap per force along a direction, by a pass, and by the bound of it.
  double found_softness(const NodeVector& along) {
    carriers.push(terms, weights, along);
    mobility.begin_passes();
    return carriers.change(terms, weights).dot(along);
  }
  double bounded_softness(const PointCarriers::Direction& direction, double area) const {
    const LeaningAreas areas = areas_of(direction, area);
    double sum = 0.0;
    for (std::size_t i = 0; i < terms.n_terms; ++i)
      sum += carriers.share(terms, weights, i, direction, areas) / area;
    return sum;
  }
};

const NodeVector along_z(0, 0, 1, 0);

}  // namespace

TEST_CASE("the shares of nodes in a point are positive on the first side", "[contact][point_carriers]") {
  CarriedCubes cubes;
  cubes.begin();
  ContactPoint point = test::TwoCubes::corner_over_face();
  point.second.weights << 0.5, 0.5, 0.0, 0.0;
  REQUIRE(cubes.carriers.find_plain(point, cubes.terms, cubes.weights));
  REQUIRE(cubes.terms.n_terms == 3);
  CHECK_FALSE(cubes.terms.first_arm);
  CHECK(cubes.mobility.mesh_nodes() == std::vector<std::uint32_t>{8, 4, 5});
  CHECK(cubes.weights[0] == 1.0);
  CHECK(cubes.weights[1] == -0.5);
  CHECK(cubes.weights[2] == -0.5);
}

TEST_CASE("points between the same entities share their terms, however many corners each needs",
          "[contact][point_carriers]") {
  CarriedCubes cubes;
  cubes.begin();
  ContactPoint point = test::TwoCubes::corner_over_face();
  point.second.weights << 0.5, 0.5, 0.0, 0.0;
  REQUIRE(cubes.carriers.find_plain(point, cubes.terms, cubes.weights));
  point.second.weights << 0.0, 0.25, 0.75, 0.0;
  PointCarriers::Weights others{};
  REQUIRE(cubes.carriers.find_plain(point, cubes.terms, others));
  CHECK(cubes.terms.n_terms == 4);
  CHECK(others[0] == 1.0);
  CHECK(others[1] == 0.0);  // of a corner of the first point alone
  CHECK(others[2] == -0.25);
  CHECK(others[3] == -0.75);
  CHECK(cubes.mobility.mesh_nodes()[cubes.terms.carriers[3]] == 7);
}

TEST_CASE("a point on a rigid body has no plain carriers but two of any kind", "[contact][point_carriers]") {
  CarriedCubes cubes;
  cubes.cubes.make_rigid();
  cubes.begin();
  ContactPoint point = test::TwoCubes::corner_over_face();
  point.first.nodes = {8, 9, 9, 9};
  point.first.weights << 0.5, 0.5, 0.0, 0.0;
  point.first.radius = 0.25;
  CHECK_FALSE(cubes.carriers.find_plain(point, cubes.terms, cubes.weights));
  cubes.weights = {};
  cubes.carriers.find_general(point, cubes.terms, cubes.weights);
  REQUIRE(cubes.terms.n_terms == 5);
  REQUIRE(cubes.terms.first_arm);
  CHECK(cubes.weights[0] == 1.0);
  CHECK(cubes.carriers.arm(cubes.terms, 0).isApprox(Vector3d(0, -0.5, -0.75)));
  CHECK(cubes.weights[4] == -0.25);
  CHECK(cubes.carriers.arm(cubes.terms, 4).isZero(0.0));
}

TEST_CASE("a push on both sides leaves no momentum and moves the point as its carriers allow",
          "[contact][point_carriers]") {
  CarriedCubes cubes;
  cubes.begin();
  REQUIRE(cubes.carriers.find_plain(test::TwoCubes::corner_over_face(), cubes.terms, cubes.weights));
  const NodeVector force(1, 2, 4, 0);
  cubes.carriers.push(cubes.terms, cubes.weights, force);
  cubes.mobility.begin_passes();
  NodeVector sum = NodeVector::Zero();
  for (std::uint32_t i = 0; i < cubes.mobility.n_carriers(); ++i) sum += cubes.mobility.change(i);
  CHECK(sum.norm() < 1e-15);
  // 1 / m of the node, 4 (1 / 4)^2 / m of the face.
  CHECK(cubes.carriers.change(cubes.terms, cubes.weights).isApprox(half_steps * 2.5 * force));
}

TEST_CASE("the softness of a point that is alone is that of its carriers, whatever its area",
          "[contact][point_carriers]") {
  const double area = GENERATE(1e-6, 1.0, 1e6);
  const bool is_rigid = GENERATE(false, true);
  CarriedCubes cubes;
  if (is_rigid) cubes.cubes.make_rigid();
  cubes.begin();
  ContactPoint point = test::TwoCubes::corner_over_face();
  point.second.weights << 0.1, 0.2, 0.3, 0.4;
  if (!cubes.carriers.find_plain(point, cubes.terms, cubes.weights)) {
    cubes.weights = {};
    cubes.carriers.find_general(point, cubes.terms, cubes.weights);
  }
  const double bound = cubes.bounded_softness({along_z}, area);
  // Of the body 1 / m + a n I^-1 n a with the arm (-0.5, -0.5, -0.5).
  const double of_first = is_rigid ? 1.0 / 8.0 + 0.25 * 0.25 + 0.25 * 0.25 : 2.0;
  CHECK(bound == Approx(half_steps * (of_first + 2.0 * (0.01 + 0.04 + 0.09 + 0.16))));
  CHECK(cubes.found_softness(along_z) == Approx(bound));
}

TEST_CASE("with friction a body turns by its largest mobility", "[contact][point_carriers]") {
  CarriedCubes cubes;
  cubes.cubes.make_rigid();
  cubes.begin();
  cubes.carriers.find_general(test::TwoCubes::corner_over_face(), cubes.terms, cubes.weights);
  const double bound = cubes.bounded_softness({along_z, true}, 2.0);
  CHECK(bound == Approx(half_steps * (1.0 / 8.0 + 0.5 * 0.75 + 0.5)));
  CHECK(cubes.found_softness({0.6, 0.8, 0, 0}) < bound);
}

TEST_CASE("points that lean on one carrier soften each other", "[contact][point_carriers]") {
  CarriedCubes cubes;
  cubes.begin();
  ContactPoint point = test::TwoCubes::corner_over_face();
  point.second.weights = Eigen::Vector4d::UnitX();
  REQUIRE(cubes.carriers.find_plain(point, cubes.terms, cubes.weights));
  LeaningAreas areas = cubes.areas_of({along_z}, 2.0);
  CHECK(areas[0][0] == 2.0);
  CHECK(areas[1][0] == 2.0);
  CHECK(cubes.carriers.share(cubes.terms, cubes.weights, 0, {along_z}, areas) == Approx(0.2 * 2.0));
  cubes.carriers.add_areas(cubes.terms, cubes.weights, {along_z}, 3.0, areas);
  CHECK(cubes.carriers.share(cubes.terms, cubes.weights, 0, {along_z}, areas) == Approx(0.2 * 5.0));
}

TEST_CASE("what leans on a carrier is counted by side", "[contact][point_carriers]") {
  CarriedCubes cubes;
  cubes.cubes.hold({{5}}, Components{{true, true, true}});
  cubes.begin();
  ContactPoint point = test::TwoCubes::corner_over_face();
  point.second.weights << 0.5, 0.5, 0.0, 0.0;
  REQUIRE(cubes.carriers.find_plain(point, cubes.terms, cubes.weights));
  const LeaningAreas areas = cubes.areas_of({along_z}, 2.0);
  std::vector<CarrierLoad> loads(3);
  cubes.carriers.add_loads(cubes.terms, cubes.weights, {along_z}, 2.0, areas, loads);
  CHECK(loads[0].own == Approx(0.2 * 2.0));
  CHECK(loads[0].others == Approx(0.2 * 0.5 * 1.0));  // the held corner does not give way
  CHECK(loads[0].area == 2.0);
  CHECK(loads[1].own == Approx(0.1));
  CHECK(loads[1].others == Approx(0.4));
  CHECK(loads[1].area == 1.0);
  CHECK(loads[2].own == Approx(0.1));
}

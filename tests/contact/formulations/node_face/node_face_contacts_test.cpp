// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/node_face/node_face_contacts.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/tip_on_floor.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

constexpr double stiffness = tip_stiffness;

const std::string rough =
    "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 50\n";

}  // namespace

TEST_CASE("a node that hangs over an edge leaves no moment", "[contact][node_face_contacts]") {
  TipOnFloor parts("tangential tolerance = 0.2\n");
  parts.put({-0.1, 0.7, 0.01});
  const auto points = parts.put({-0.1, 0.7, -0.01}, true);
  REQUIRE(points.size() == 1);
  REQUIRE(points[0].touches());
  Vector3d under = Vector3d::Zero();
  for (std::size_t k = 0; k < 4; ++k)
    under += points[0].second.weights[static_cast<int>(k)] * parts.kinematics.x(points[0].second.nodes[k]);
  CHECK((under - Vector3d(-0.1, 0.7, 0.0)).norm() < 1e-12);
}

TEST_CASE("a node apart from a face gets no force, nor one beyond its edge",
          "[contact][node_face_contacts]") {
  TipOnFloor parts;
  CHECK(parts.put({0.6, 0.7, 1e-9}).empty());
  CHECK(parts.put({-0.1, 0.7, -0.01}).empty());
  CHECK(parts.put({2.1, 2.1, -0.01}).empty());
  CHECK(parts.put({0.6, 0.7, -0.01}).size() == 1);
  TipOnFloor tolerant("tangential tolerance = 0.2\n");
  tolerant.put({-0.1, 0.7, 0.01});
  CHECK(tolerant.put({-0.1, 0.7, -0.01}, true).size() == 1);
  CHECK(tolerant.put({-0.3, 0.7, -0.01}, true).empty());
}

TEST_CASE("a node that comes near is reported before it touches", "[contact][node_face_contacts]") {
  TipOnFloor parts;
  parts.put({0.6, 0.7, 0.03});
  const auto points = parts.put({0.6, 0.7, 0.015}, true);
  REQUIRE(points.size() == 1);
  CHECK(!points[0].touches());
  CHECK(points[0].stiffness == Approx(stiffness * tip_area));
  CHECK(parts.put({0.6, 0.7, 0.016}, true).empty());
}

TEST_CASE("a node that turns up deep inside did not go in there", "[contact][node_face_contacts]") {
  TipOnFloor parts;
  // The tetrahedron is the thinner of both: thrice its volume over its area, 0.447.
  CHECK(parts.put({0.6, 0.7, -0.23}).empty());
  CHECK(parts.put({0.6, 0.7, -0.22}).size() == 1);  // at the start it is pushed out
  CHECK(parts.look(1.0).size() == 1);
  TipOnFloor later;
  later.put({0.6, 0.7, 0.5});
  later.search();
  later.x.middleCols<4>(8).row(2).array() -= 0.7;
  later.search();
  later.contacts.take_candidates(later.node_faces);
  CHECK(later.look(1.0).empty());
}

TEST_CASE("a node that went in goes on touching however deep it gets", "[contact][node_face_contacts]") {
  TipOnFloor parts;
  parts.put({0.6, 0.7, 0.02});
  std::vector<LostContact> lost;
  for (int step = 1; step <= 18; ++step) {  // far through the floor, which is 1 thick
    const auto points = parts.put({0.6, 0.7, -0.1 * step}, true);
    REQUIRE(points.size() == 1);
    CHECK(points[0].gap == Approx(-0.1 * step));
    parts.contacts.find_lost(parts.rules, lost);
  }
  CHECK(lost.empty());
  parts.put({20.0, 0.7, -1.8});
  parts.contacts.find_lost(parts.rules, lost);
  REQUIRE(lost.size() == 1);
  CHECK(lost[0].depth == Approx(1.8));
}

TEST_CASE("friction of a node goes on over the edges of faces", "[contact][node_face_contacts]") {
  TipOnFloor parts(rough);
  parts.put({0.9, 0.7, -0.1});
  for (int step = 1; step <= 20; ++step) {
    const auto points = parts.put({0.9 + 0.01 * step, 0.7, -0.1}, true);
    REQUIRE(points.size() == 1);
    CHECK(points[0].tangential.x() == Approx(-stiffness * tip_area * 0.01 * step));
    CHECK(points[0].elastic_slip.x() == Approx(0.01 * step));
  }
  parts.put({1.1, 0.7, 0.1}, true);
  REQUIRE(parts.put({1.1, 0.7, -0.1}, true).size() == 1);
  CHECK(parts.look(0.0)[0].tangential.norm() < 1e-9);  // it let go
}

TEST_CASE("damping of a node pushes when it goes in and never pulls", "[contact][node_face_contacts]") {
  TipOnFloor parts("contact damping fraction = 0.1\n");
  const double damping = 0.2 * std::sqrt(stiffness * 2.0);
  parts.put({0.6, 0.7, 0.01});
  const auto in = parts.put({0.6, 0.7, -0.01}, true);
  REQUIRE(in.size() == 1);
  CHECK(in[0].force == Approx(tip_area * (10.0 + damping * 0.02)));
  CHECK(in[0].damped == Approx(tip_area * damping * 0.02 * 0.02));
  TipOnFloor strong("contact damping fraction = 40\n");
  strong.put({0.6, 0.7, 0.01});
  REQUIRE(strong.put({0.6, 0.7, -0.01}, true).size() == 1);
  strong.v *= -0.2;
  strong.move();
  const auto apart = strong.look(1.0);
  REQUIRE(apart.size() == 1);
  CHECK(apart[0].force == 0.0);
}

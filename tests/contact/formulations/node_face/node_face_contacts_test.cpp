// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/node_face/node_face_contacts.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

constexpr double stiffness = 1000.0;
/// The tip's third of the three faces around it: each is half the product of (1, 0, 1) and its neighbour.
const double tip_area = std::sqrt(3.75) / 2.0;

/// A floor of 2 x 2 unit cells, perhaps with a wall at x = 2, and a tetrahedron that stands on its tip.
struct TipOnFloor : ContactParts {
  explicit TipOnFloor(const std::string& lines = "", bool with_wall = false)
      : ContactParts(make(with_wall), general_contact("penalty stiffness = 1000\n" + lines,
                                                      "contact surface floor contains block_1\n"
                                                      "contact node set tip contains tip\n")),
        contacts(setup()) {}
  static MeshBuilder make(bool with_wall) {
    MeshBuilder b;
    b.add_hexes({.id = 3, .origin = {50, 0, 0}});
    const double h = std::sqrt(3.0) / 2.0;
    const std::uint32_t first = b.add_node({0, 0, 0}).value;
    b.add_node({1, 0, 1});
    b.add_node({-0.5, h, 1});
    b.add_node({-0.5, -h, 1});
    b.add_block(2, "", Shape::tet4, {first, first + 1, first + 2, first + 3});
    b.add_node_set(1, "tip", std::vector<std::uint32_t>{first});
    std::vector<std::uint32_t> nodes;
    const auto add_cell = [&](int i, int j, int k) {
      for (const auto& [a, c, d] :
           {std::array{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}})
        nodes.push_back(static_cast<std::uint32_t>(((k + d) * 3 + j + c) * 4 + i + a) + first + 4);
    };
    for (int k = 0; k < 3; ++k) {
      for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 4; ++i) b.add_node({double(i), double(j), k - 1.0});
      }
    }
    for (int j = 0; j < 2; ++j) {
      add_cell(0, j, 0);
      add_cell(1, j, 0);
      if (with_wall) add_cell(2, j, 0);
      if (with_wall) add_cell(2, j, 1);
    }
    b.add_block(1, "", Shape::hex8, nodes);
    return b;
  }

  NodeFaceContacts contacts;

  /// Puts the tip somewhere, in a step of size 1 or without a velocity, and finds what it touches.
  std::vector<ContactPoint> put(const Vector3d& entity, bool in_a_step = false) {
    const Vector3d way = entity - x.col(8);
    v.setZero();
    for (Eigen::Index i = 8; i < 12; ++i) {
      x.col(i) += way;
      if (in_a_step) v.col(i) = way;
    }
    const std::vector<float> depths = contacts.depths();
    search({}, depths);
    contacts.take_candidates(node_faces);
    return look(in_a_step ? 1.0 : 0.0);
  }
  std::vector<ContactPoint> look(double dt) {
    std::vector<ContactPoint> points;
    contacts.begin_detection(context(dt));
    contacts.detect(context(dt), {0, contacts.n_rows()}, points);
    contacts.update(context(dt), {0, contacts.n_rows()}, points);
    return points;
  }
};

const std::string rough =
    "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 50\n";

}  // namespace

TEST_CASE("a node gets one force over a face, an edge and a corner, always the same",
          "[contact][node_face_contacts]") {
  for (const Vector3d& entity : {Vector3d(0.6, 0.7, 0), Vector3d(1.0, 0.7, 0), Vector3d(0.6, 1.0, 0),
                                 Vector3d(1.0, 1.0, 0), Vector3d(1.0 + 1e-12, 1.0 - 1e-12, 0)}) {
    TipOnFloor parts;
    const auto points = parts.put(entity - Vector3d(0, 0, 0.01));
    REQUIRE(points.size() == 1);
    CHECK(points[0].force == Approx(stiffness * tip_area * 0.01).epsilon(1e-12));
    CHECK((points[0].normal - Vector3d::UnitZ()).norm() < 1e-12);
    CHECK(points[0].gap == Approx(-0.01));
    CHECK(points[0].first.nodes[0] == points[0].first.nodes[3]);
    // The face's share stands under the node.
    Vector3d under = Vector3d::Zero();
    for (std::size_t k = 0; k < 4; ++k)
      under += points[0].second.weights[static_cast<int>(k)] * parts.kinematics.x(points[0].second.nodes[k]);
    CHECK((under - entity).norm() < 1e-12);
  }
}

TEST_CASE("the faces of a ridge share a node behind it, and none pushes it aside",
          "[contact][node_face_contacts]") {
  TipOnFloor parts;
  parts.put({1.0, 1.0, 0.02});
  // The middle of the top is lifted: a ridge with slopes of 0.1.
  for (Eigen::Index i = 12; i < parts.x.cols(); ++i) {
    if (parts.x(0, i) == 1.0 && parts.x(2, i) == 0.0) parts.x(2, i) = 0.1;
  }
  const auto points = parts.put({1.0, 0.7, 0.09});
  REQUIRE(points.size() == 2);
  const Vector3d force = points[0].force_on_first() + points[1].force_on_first();
  CHECK(std::abs(force[0]) < 1e-12 * force[2]);
  CHECK(points[0].force == Approx(points[1].force).epsilon(1e-12));
  const double depth = 0.01 / std::sqrt(1.01);
  CHECK(points[0].gap == Approx(-depth).epsilon(1e-9));
  CHECK(force.norm() < stiffness * 1.1 * tip_area * depth);
}

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

TEST_CASE("a node that comes near is told of before it touches", "[contact][node_face_contacts]") {
  TipOnFloor parts;
  parts.put({0.6, 0.7, 0.03});
  const auto points = parts.put({0.6, 0.7, 0.015}, true);
  REQUIRE(points.size() == 1);
  CHECK(!points[0].touches());
  CHECK(points[0].stiffness == Approx(stiffness * tip_area));
  CHECK(parts.put({0.6, 0.7, 0.016}, true).empty());
}

TEST_CASE("a node comes out where it went in", "[contact][node_face_contacts]") {
  TipOnFloor parts;
  parts.put({1.9, 0.7, 0.02});
  // It ends up nearer to the side at x = 2 than to the top.
  for (int step = 0; step < 10; ++step) {
    const auto points = parts.put({1.9, 0.7, -0.02 * step}, true);
    if (step == 0) continue;
    REQUIRE(points.size() == 1);
    CHECK((points[0].normal - Vector3d::UnitZ()).norm() < 1e-12);
    CHECK(points[0].gap == Approx(-0.02 * step));
  }
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

TEST_CASE("in a hollow a node touches both walls", "[contact][node_face_contacts]") {
  TipOnFloor parts("", true);
  const auto points = parts.put({2.02, 0.7, -0.01});
  REQUIRE(points.size() == 2);
  double along_x = 0.0, along_z = 0.0;
  for (const ContactPoint& point : points) {
    along_x += point.force * point.normal.x();
    along_z += point.force * point.normal.z();
  }
  CHECK(along_z == Approx(stiffness * tip_area * 0.01));
  CHECK(along_x < -1.0);
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

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/face_face/face_face_contacts.hpp"

#include <algorithm>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

constexpr double stiffness = 1000.0;

/// A plate of 3 x 3 unit cells and a cube on it that stands over the first cells in x, numbered in either
/// order.
struct CubeOnPlate : ContactParts {
  explicit CubeOnPlate(const std::string& lines = "", bool cube_first = false)
      : ContactParts(make(cube_first), general_contact("penalty stiffness = 1000\n" + lines)),
        contacts(setup()),
        cube(cube_first ? 0 : 1) {
    search();
    contacts.take_candidates(face_partners);
  }
  static MeshBuilder make(bool cube_first) {
    const test::Box plate{.id = 1, .cells = {3, 3, 1}, .size = {3, 3, 1}, .share_nodes = false},
        small{.id = 2, .origin = {0.2, 1.1, 1.0}, .size = {0.5, 0.5, 1.0}, .share_nodes = false};
    MeshBuilder b;
    if (cube_first) b.add_hexes(small);
    b.add_hexes(plate);
    if (!cube_first) b.add_hexes(small);
    return b;
  }

  FaceFaceContacts contacts;
  std::uint32_t cube;  ///< its block
  double size = 0.0;   ///< of the last step

  /// Moves the cube in a step of size 1, or puts it there without a velocity.
  void move_cube(const Vector3d& way, bool in_a_step = true) {
    v.setZero();
    size = in_a_step ? 1.0 : 0.0;
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
      const auto& nodes = mesh.blocks()[cube].nodes;
      if (std::count(nodes.begin(), nodes.end(), NodeIndex{static_cast<std::uint32_t>(i)}) == 0) continue;
      x.col(i) += way;
      if (in_a_step) v.col(i) = way;
    }
    move();
  }
  void renew_candidates() {
    search(contacts.depths());
    contacts.take_candidates(face_partners);
  }
  std::vector<ContactPoint> find() {
    std::vector<ContactPoint> points;
    contacts.begin_step();
    contacts.detect(context(size), {0, contacts.n_rows()}, points);
    contacts.update(context(size), {0, contacts.n_rows()}, points);
    return points;
  }
  /// The sum of the forces on the cube.
  Vector3d force_on_cube(const std::vector<ContactPoint>& points) const {
    Vector3d sum = Vector3d::Zero();
    for (const ContactPoint& point : points)
      sum += (contact_mesh.faces[point.first_face()].surface == SurfaceIndex{cube} ? 1.0 : -1.0) *
             point.force_on_first();
    return sum;
  }
};

}  // namespace

TEST_CASE("a cube in a plate is pushed out by stiffness, area and depth", "[contact][face_face_contacts]") {
  const bool cube_first = GENERATE(false, true);
  CubeOnPlate parts("", cube_first);
  parts.move_cube({0, 0, -0.01}, false);
  const auto points = parts.find();
  CHECK((parts.force_on_cube(points) - Vector3d(0, 0, 2.5)).norm() < 1e-12);
  REQUIRE(points.size() == 1);
  CHECK(points[0].area == Approx(0.25));
  CHECK(points[0].gap == Approx(-0.01));
  CHECK(points[0].stiffness == Approx(250.0));
  CHECK(points[0].first_entity < points[0].second_entity);
  CHECK(points[0].first.weights.sum() == Approx(1.0));
  CHECK(points[0].is_swapped == false);
  parts.move_cube({0.55, 0, 0}, false);  // over two cells
  parts.renew_candidates();
  CHECK(parts.find().size() == 2);
  CHECK((parts.force_on_cube(parts.find()) - Vector3d(0, 0, 2.5)).norm() < 1e-12);
}

TEST_CASE("contact begins up to half an element deep, and goes on however deep it gets",
          "[contact][face_face_contacts]") {
  CubeOnPlate jumped;
  jumped.move_cube({0, 0, -0.55}, false);
  CHECK(jumped.find().empty());
  CubeOnPlate pushed;
  pushed.move_cube({0, 0, -0.3});
  CHECK(!pushed.find().empty());
  for (int step = 1; step <= 6; ++step) {  // far through the plate, which is 1 thick
    pushed.move_cube({0, 0, -0.25});
    if (step % 2 == 0) pushed.renew_candidates();
    const auto points = pushed.find();
    REQUIRE(points.size() == 1);
    CHECK(points[0].gap == Approx(-0.3 - 0.25 * step));
  }
  std::vector<LostContact> lost;
  pushed.contacts.find_lost(pushed.rules, lost);
  CHECK(lost.empty());
  pushed.move_cube({5, 0, 0}, false);
  CHECK(pushed.find().empty());
  pushed.contacts.find_lost(pushed.rules, lost);
  REQUIRE(lost.size() == 1);
  CHECK(lost[0].depth == Approx(1.8));
  CubeOnPlate fast;  // what a step has brought in is in touch
  fast.move_cube({0, 0, -0.7});
  CHECK(!fast.find().empty());
}

TEST_CASE("faces that will touch soon are told of without a force", "[contact][face_face_contacts]") {
  CubeOnPlate parts;
  parts.move_cube({0, 0, 0.029}, false);
  CHECK(parts.find().empty());
  parts.move_cube({0, 0, -0.01});
  REQUIRE(parts.find().size() == 1);  // two steps of 0.01 away
  CHECK(!parts.find()[0].touches());
  CHECK(parts.find()[0].stiffness == Approx(250.0));
  parts.move_cube({0, 0, 0.001});
  CHECK(parts.find().empty());
}

TEST_CASE("friction goes on when a face slides from one partner to the next",
          "[contact][face_face_contacts]") {
  const bool cube_first = GENERATE(false, true);
  CubeOnPlate parts(
      "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 50\n",
      cube_first);
  parts.move_cube({0, 0, -0.1}, false);
  CHECK(parts.find().size() == 1);
  double slipped = 0.0;
  for (int step = 0; step < 100; ++step) {
    parts.move_cube({0.01, 0, 0});
    if (step % 10 == 0) parts.renew_candidates();
    const auto points = parts.find();
    slipped += 0.01;
    const Vector3d force = parts.force_on_cube(points);
    // It sticks all the way, over two edges. The sliver on a new partner, no wider than the way of a step,
    // may be a flush rim for that step.
    CHECK(force.z() == Approx(25.0).epsilon(0.021));
    CHECK(force.x() == Approx(-stiffness * 0.25 * slipped).epsilon(0.021));
    CHECK(std::abs(force.y()) < 1e-9);
  }
}

TEST_CASE("friction slides at its limit and tells what it takes", "[contact][face_face_contacts]") {
  CubeOnPlate parts(
      "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 0.5\n");
  parts.move_cube({0, 0, -0.1}, false);
  parts.find();
  for (int step = 0; step < 10; ++step) {
    parts.move_cube({0.02, 0.0, 0});
    const auto points = parts.find();
    double lost = 0.0;
    for (const ContactPoint& point : points) lost += point.dissipated;
    const Vector3d force = parts.force_on_cube(points);
    CHECK(force.x() == Approx(-std::min(12.5, stiffness * 0.25 * 0.02 * (step + 1))));
    CHECK(lost == Approx(step < 2 ? 0.0 : step == 2 ? 12.5 * 0.01 : 12.5 * 0.02).margin(1e-12));
  }
}

TEST_CASE("pairs that leave the candidates are forgotten", "[contact][face_face_contacts]") {
  CubeOnPlate parts;
  parts.move_cube({0, 0, -0.4}, false);
  CHECK(!parts.find().empty());
  parts.move_cube({0, 0, -0.2}, false);
  parts.renew_candidates();
  CHECK(!parts.find().empty());
  parts.contacts.take_candidates({});
  CHECK(parts.find().empty());
  parts.renew_candidates();
  CHECK(parts.find().empty());  // as deep as before, but not known any more
}

TEST_CASE("pairs that are tied, or not active, do not touch", "[contact][face_face_contacts]") {
  CubeOnPlate tied("friction model = tied\n");
  tied.move_cube({0, 0, -0.01}, false);
  CHECK(tied.find().empty());
  CubeOnPlate parts;
  parts.move_cube({0, 0, -0.01}, false);
  parts.rules.activate(0.0, false);
  CHECK(parts.find().empty());
  parts.rules.activate(0.0, true);
  CHECK(!parts.find().empty());
}

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/face_face/face_face_contacts.hpp"

#include "support/catch.hpp"
#include "support/cube_on_plate.hpp"

using namespace contactsim;
using namespace contactsim::test;

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

TEST_CASE("faces that will touch soon are reported without a force", "[contact][face_face_contacts]") {
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

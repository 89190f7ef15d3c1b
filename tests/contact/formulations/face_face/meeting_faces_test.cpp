// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/face_face/meeting_faces.hpp"

#include "support/catch.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Unit squares, the first one 0.1 above the second.
struct FacingSquares {
  MovingFace first = make_square(0.0, 0.1, false), second = make_square(0.0, 0.0, true);

  MeetingFaces meeting() const { return {first, second, nullptr, nullptr, 0.0, false}; }
};

/// All of what is nearer than 1.
constexpr ConstraintActivation all_near{1.0, 1.0, 1.0, 1.0, 0.01};

}  // namespace

TEST_CASE("an offset is taken off the gap of two faces, wherever they face", "[contact][meeting_faces]") {
  FacingSquares squares;
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  squares.first = turned(squares.first, rotation, {1, 2, 3});
  squares.second = turned(squares.second, rotation, {1, 2, 3});
  const FaceCorners before = squares.first.x;
  take_off_gap(0.0, squares.second, squares.first);
  CHECK(squares.first.x == before);
  take_off_gap(0.03, squares.second, squares.first);
  double area = 0.0;
  const FaceFaceConstraints found = squares.meeting().find_constraints(all_near);
  for (const OverlapShare& share : found.all()) {
    const FaceFaceContact contact = contact_of(share, squares.first, squares.second);
    CHECK(contact.gap == Approx(0.07));
    CHECK(contact.normal.isApprox(rotation.col(2)));
    CHECK(contact.force == 0.0);
    area += contact.area;
  }
  CHECK(area == Approx(1.0));
  // Faces that look the same way have no common plane.
  FacingSquares others;
  others.first = make_square(0.0, 0.1, true);
  take_off_gap(0.03, others.second, others.first);
  CHECK(others.first.x == make_square(0.0, 0.1, true).x);
}

TEST_CASE("the still face goes along with the one that slides, and bears by its own corners",
          "[contact][meeting_faces]") {
  FacingSquares squares;
  // By half of the edge from the first corner to the second.
  PartnerCarry carry;
  carry.is_of_first = GENERATE(true, false);
  carry.weights << -0.5, 0.5, 0.0, 0.0;
  const FacingSquares before = squares;
  carry_along(carry, squares.first, squares.second);
  const MovingFace &still = carry.is_of_first ? squares.first : squares.second,
                   &was = carry.is_of_first ? before.first : before.second;
  const Eigen::Vector3d half_edge = 0.5 * (was.x.col(1) - was.x.col(0));
  for (int k = 0; k < 4; ++k) CHECK(still.x.col(k).isApprox(was.x.col(k) + half_edge));
  const MovingFace &other = carry.is_of_first ? squares.second : squares.first,
                   &other_was = carry.is_of_first ? before.second : before.first;
  CHECK(other.x == other_was.x);
  ContactPoint point;
  point.first.weights.setConstant(0.25);
  point.second.weights.setConstant(0.25);
  carry_along(carry, point);
  CHECK((carry.is_of_first ? point.first : point.second).weights == Eigen::Vector4d(-0.25, 0.75, 0.25, 0.25));
  CHECK((carry.is_of_first ? point.second : point.first).weights == Eigen::Vector4d::Constant(0.25));
}

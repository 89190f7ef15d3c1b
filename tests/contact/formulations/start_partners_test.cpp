// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/start_partners.hpp"

#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

MovingFace quad() {
  MovingFace face;
  face.x << 0, 2, 3, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  face.v << 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 4;
  return face;
}

MovingFace triangle() {
  MovingFace face;
  face.is_triangle = true;
  face.x << 0, 1, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1;
  face.v.setZero();
  return face;
}

}  // namespace

TEST_CASE("the plane of a face goes on beyond its edges", "[contact][start_partners]") {
  for (const MovingFace& face : {quad(), triangle()}) {
    for (const Vector3d& point : {Vector3d(9, -3, 1.25), Vector3d(-40, 30, 1.25), Vector3d(0.2, 0.3, 0.5)}) {
      const PlanePoint found = project_onto_plane(face, point);
      CHECK(found.normal.isApprox(Vector3d::UnitZ()));
      CHECK(found.gap == Approx(point.z() - face.x(2, 0)));
      CHECK(found.weights.sum() == Approx(1.0));
      // Right below the point: forces along the normal leave no moment.
      CHECK((face.x * found.weights - (point - found.gap * found.normal)).norm() < 1e-12);
    }
  }
}

TEST_CASE("the plane of a warped face goes on flat from its edge", "[contact][start_partners]") {
  MovingFace face = quad();
  face.x(2, 2) = 0.1;
  const PlanePoint at = project_onto_plane(face, {3.001, 0.5, 0.0}),
                   far = project_onto_plane(face, {6, 0.5, 0.0});
  CHECK(at.normal.isApprox(far.normal));
  CHECK((face.x * far.weights + far.gap * far.normal - Vector3d(6, 0.5, 0.0)).norm() < 1e-12);
  CHECK(far.beyond > at.beyond);
}

TEST_CASE("a face is carried with the velocities that belong there", "[contact][start_partners]") {
  PartnerCarry carry;
  CHECK(carry.is_zero());
  carry.weights = {-0.5, 0.5, 0.25, -0.25};
  const MovingFace face = quad(), carried = carry.carried(face);
  const Vector3d way = face.x * carry.weights, faster = face.v * carry.weights;
  for (Eigen::Index k = 0; k < 4; ++k) {
    CHECK((carried.x.col(k) - face.x.col(k) - way).norm() < 1e-14);
    CHECK((carried.v.col(k) - face.v.col(k) - faster).norm() < 1e-14);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/degenerate_faces.hpp"

#include "support/catch.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using Eigen::Vector3d;
using test::ContactParts;

namespace {

/// Two unit cubes, far from each other; `corner` is the node of the first at (1, 1, 1).
struct Cubes : ContactParts {
  Cubes() : ContactParts(test::stacked_cubes(5.0), test::general_contact()) {
    while (!mesh.coordinates().col(corner).isApprox(Vector3d::Ones())) ++corner;
  }
  std::vector<ElementIndex> with_corner_at(const Vector3d& place,
                                           const Vector3d& shift = Vector3d::Zero()) const {
    Eigen::Matrix3Xd coordinates = mesh.coordinates();
    coordinates.col(corner) = place;
    coordinates.colwise() += shift;
    return find_degenerate_faces(contact_mesh, coordinates);
  }
  Eigen::Index corner = 0;
};

using Elements = std::vector<ElementIndex>;

}  // namespace

TEST_CASE("a face has lost its shape when a corner is turned over", "[contact][degenerate_faces]") {
  const Cubes cubes;
  CHECK(cubes.with_corner_at({1, 1, 1}).empty());
  // Along the diagonal of the top: the corner is flat where it meets the line between its neighbours.
  CHECK(cubes.with_corner_at({0.6, 0.6, 1}).empty());
  CHECK(cubes.with_corner_at({0.4, 0.4, 1}) == Elements{{0}});  // of three faces, named once
}

TEST_CASE("a corner that is flat to a hundredth of a right one has lost its shape",
          "[contact][degenerate_faces]") {
  const Cubes cubes;
  // At (1/2 + d, 1/2 + d) the product of the edges is 2 d; a hundredth of the mean squared edge, about 0.75.
  CHECK(cubes.with_corner_at({0.505, 0.505, 1}).empty());
  CHECK(cubes.with_corner_at({0.503, 0.503, 1}) == Elements{{0}});
}

TEST_CASE("shapes are seen far from the origin too", "[contact][degenerate_faces]") {
  const Cubes cubes;
  const Vector3d far(1e8, -1e8, 1e8);
  CHECK(cubes.with_corner_at({1, 1, 1}, far).empty());
  CHECK(cubes.with_corner_at({0.25, 0.25, 1}, far) == Elements{{0}});
}

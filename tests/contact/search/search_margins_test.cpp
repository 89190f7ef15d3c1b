// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/search_margins.hpp"

#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Margins are of single precision.
constexpr double margin_precision = 1e-6;

/// A unit cube of one element below one of 10 x 10 x 10.
struct CubesWithMargins {
  ContactParts parts{cubes(), general_contact()};
  SearchMargins margins;

  CubesWithMargins() {
    margins.set(parts.contact_mesh, parts.mesh, 0.15);
    margins.start_at(parts.contact_mesh, parts.kinematics);
  }
  static MeshBuilder cubes() {
    MeshBuilder b;
    b.add_hexes({.id = 1});
    b.add_hexes({.id = 2, .cells = {10, 10, 10}, .origin = {0, 0, 5}, .share_nodes = false});
    return b;
  }
  IndexedVector<SurfaceIndex, double> used() {
    parts.move();
    return margins.used(parts.contact_mesh, parts.kinematics);
  }
};

}  // namespace

TEST_CASE("margins are a share of the roots of areas, of nodes the least around them",
          "[contact][search_margins]") {
  const CubesWithMargins cubes;
  // Faces of area 1 and 0.01; the corner of a cube has a quarter of three faces.
  for (const FaceIndex face : indices(cubes.parts.contact_mesh.faces)) {
    const bool is_coarse = cubes.parts.contact_mesh.faces[face].surface.value == 0;
    CHECK(cubes.margins.of(face) == Approx(is_coarse ? 0.15 : 0.015).epsilon(margin_precision));
  }
  CHECK(cubes.margins.of(ContactNodeIndex{0}) == Approx(0.15 * std::sqrt(0.75)).epsilon(margin_precision));
  CHECK(cubes.margins.of(ContactNodeIndex{8}) == Approx(0.15 * std::sqrt(0.0075)).epsilon(margin_precision));
  // The next one on the edge has four quarters.
  CHECK(cubes.margins.of(ContactNodeIndex{9}) == Approx(0.015).epsilon(margin_precision));
}

TEST_CASE("motion uses margins up from the last search on", "[contact][search_margins]") {
  CubesWithMargins cubes;
  // At rest the rounding at the corner (1, 1, 1) alone.
  const double at_rest = 0x1p-24 * 3.0 / (0.15 * std::sqrt(0.75));
  CHECK(cubes.used()[{0}] == Approx(at_rest).epsilon(margin_precision));
  cubes.parts.x(0, 3) += 0.03;
  cubes.parts.x(1, 3) -= 0.04;
  cubes.parts.x(2, 5) += 0.02;
  const auto used = cubes.used();
  CHECK(used[{0}] == Approx(0.05 / (0.15 * std::sqrt(0.75))).epsilon(1e-5));
  CHECK(used[{1}] < 1e-4);
  cubes.margins.start_at(cubes.parts.contact_mesh, cubes.parts.kinematics);
  CHECK(cubes.used()[{0}] < 2.0 * at_rest);
}

TEST_CASE("the rounding of single precision counts as motion", "[contact][search_margins]") {
  CubesWithMargins cubes;
  // No node has moved; the farthest is some 5 + 1 + 1 away from the first.
  const double least = 0x1p-24 * 7.0 / (0.15 * std::sqrt(0.0075));
  CHECK(cubes.used()[{1}] > least);
}

TEST_CASE("a node without a finite position leaves no margin", "[contact][search_margins]") {
  CubesWithMargins cubes;
  cubes.parts.x(1, 2) = std::numeric_limits<double>::quiet_NaN();
  const auto used = cubes.used();
  CHECK(std::isnan(used[{0}]));
  CHECK(!std::isnan(used[{1}]));
  CHECK_FALSE(cubes.margins.has_room({0}, used[{0}], {1}, 0.0));
}

TEST_CASE("a surface may use what the narrowest margin of the other has left", "[contact][search_margins]") {
  const CubesWithMargins cubes;
  const double widest = 0.15, narrowest = 0.15 * std::sqrt(0.0075);
  CHECK(cubes.margins.has_room({0}, 1.0, {1}, 1.0));
  for (const double other : {0.0, 0.5}) {
    const double most = 1.0 + (1.0 - other) * narrowest / widest;
    CHECK(cubes.margins.has_room({0}, most - 1e-5, {1}, other));
    CHECK_FALSE(cubes.margins.has_room({0}, most + 1e-5, {1}, other));
  }
}

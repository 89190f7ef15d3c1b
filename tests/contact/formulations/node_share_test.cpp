// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/node_share.hpp"

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A unit cube of n x n x n cells at a place of a plate of 3 x 3 cells of size 1, above or below it.
struct CubeOnPlate {
  double x, y;
  int n = 1;
  bool is_first = false;  ///< the cube is the first block, whose surface leads
};

/// What holds the cube to the plate by an adhesion of 5000.
double pull_on_cube(const CubeOnPlate& cube, const std::string& formulation) {
  CAPTURE(cube.x, cube.y, cube.n, cube.is_first, formulation);
  const std::size_t own = cube.is_first ? 0 : 1;
  MeshBuilder b;
  const auto add_cube = [&](int id) {
    b.add_hexes(
        {.id = id, .cells = {cube.n, cube.n, cube.n}, .origin = {cube.x, cube.y, 1.0}, .share_nodes = false});
  };
  if (cube.is_first) add_cube(1);
  b.add_hexes({.id = 2, .cells = {3, 3, 1}, .size = {3, 3, 1}, .share_nodes = false});
  if (!cube.is_first) add_cube(3);
  ContactBodies bodies(
      b,
      general_contact("friction model = sticky\nconstraint formulation = " + formulation +
                      "\nend\nbegin adhesion model sticky\nadhesion function = even\n"),
      "begin function even\ntype = piecewise linear\nbegin values\n0 5000\n1 5000\nend\nend\n");
  bodies.shift(own, {0, 0, 0.01});
  bodies.step(1.0);
  CHECK(bodies.net_force().norm() < 1e-9);
  return -bodies.force_on(own).z();
}

}  // namespace

TEST_CASE("laws in tractions hold all of the area, and once, by faces",
          "[contact][contact_force][face_face]") {
  CHECK(pull_on_cube({1.0, 1.0}, "face_face") == Approx(5000.0).epsilon(1e-6));
  CHECK(pull_on_cube({0.6, 1.5, 3}, "face_face") == Approx(5000.0).epsilon(1e-6));
}

TEST_CASE("nodes of both sides share an interface: its area counts once, wherever they lie",
          "[contact][contact_force][node_face]") {
  for (const bool is_first : {false, true}) {
    for (const auto& [x, y] :
         {std::pair(1.0, 1.0), std::pair(1.3, 1.2), std::pair(0.6, 1.5), std::pair(0.1, 0.1),
          std::pair(1.9, 0.1), std::pair(1.0, 1.4), std::pair(0.0, 0.0), std::pair(2.0, 1.7)})
      CHECK(pull_on_cube({x, y, 1, is_first}, "node_face") == Approx(5000.0).epsilon(1e-6));
  }
}

TEST_CASE("nodes of a finer side share an interface with those of a coarse one",
          "[contact][contact_force][node_face]") {
  for (const bool is_first : {false, true}) {
    for (const int n : {2, 3, 5}) {
      for (const auto& [x, y] :
           {std::pair(1.0, 1.0), std::pair(1.3, 1.2), std::pair(0.6, 1.5), std::pair(0.1, 0.1)})
        CHECK(pull_on_cube({x, y, n, is_first}, "node_face") == Approx(5000.0).epsilon(0.02));
    }
  }
}

TEST_CASE("of a body that stands out over another the nodes inside hold what lies over it",
          "[contact][contact_force][node_face]") {
  for (const bool is_first : {false, true})
    CHECK(pull_on_cube({2.5, 1.0, 1, is_first}, "node_face") == Approx(2500.0).epsilon(1e-6));
  // Less than a cell of the coarse plate lies under the cube: its finer side has to lead.
  CHECK(pull_on_cube({2.4, 2.4, 5, true}, "node_face") == Approx(1800.0).epsilon(0.05));
}

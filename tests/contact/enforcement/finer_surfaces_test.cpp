// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/finer_surfaces.hpp"

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two cubes of which the upper one has so many cells a side; the lower one has two.
MeshBuilder cubes(int upper) {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}});
  return b.add_hexes({.id = 2, .cells = {upper, upper, upper}, .origin = {0, 0, 1}, .share_nodes = false});
}

/// The finer surface of the pair, with the stiffness behind the lower one times a factor.
SurfaceIndex finer(int upper, double factor, bool is_lower_rigid = false) {
  ContactBodies bodies(cubes(upper), general_contact());
  ContactMesh contact_mesh = bodies.contact.contact_mesh();
  for (const SurfaceNodeIndex row : contact_mesh.rows_of({0})) {
    contact_mesh.surface_nodes[row].penalty_properties.stiffness *= factor;
    contact_mesh.surface_nodes[row].penalty_properties.is_rigid = is_lower_rigid;
  }
  return find_finer_surfaces(bodies.definition, contact_mesh)[PairIndex{0}];
}

constexpr SurfaceIndex lower{0}, upper{1};

}  // namespace

TEST_CASE("the finer surface of a pair is that of the smaller faces", "[contact][enforcement]") {
  CHECK(finer(4, 1.0) == upper);
  CHECK(finer(1, 1.0) == lower);
}

TEST_CASE("a softer surface may have coarser faces, up to nine times their area", "[contact][enforcement]") {
  // Nodes of the upper one have a quarter of the area of those of the lower one, or less.
  CHECK(finer(4, 1e-3) == lower);
  CHECK(finer(20, 1e-3) == upper);
  CHECK(finer(1, 1e3) == upper);
}

TEST_CASE("a rigid surface is the stiffer one whatever is behind it", "[contact][enforcement]") {
  CHECK(finer(1, 1e-3, true) == upper);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/shell_sides.hpp"

#include "contact/surfaces/surface_pairs.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A lofted plate, which is the first surface, under a cube.
struct SidedPlate {
  ContactParts parts{plate(), general_contact()};
  SurfacePair pair = parts.model.pairs[{0}];

  static MeshBuilder plate() {
    MeshBuilder b;
    add_plate(b, {.id = 1}, 0.2);
    return b.add_hexes({.id = 2, .origin = {0, 0, 1}, .share_nodes = false});
  }
  bool takes(const ContactFace& face) const { return takes_part(pair, face, parts.contact_mesh, parts.mesh); }
  bool takes(const SurfaceNode& node) const { return takes_part(pair, node, parts.contact_mesh, parts.mesh); }
  bool is_shell(ElementSide side) const { return side.element() == ElementIndex{0}; }
};

}  // namespace

TEST_CASE("both sides of a shell take part with its rims, one side without them", "[contact][shell_sides]") {
  SidedPlate plate;
  std::size_t n_both = 0, n_top = 0, n_bottom = 0;
  for (const ContactFace& face : plate.parts.contact_mesh.faces) {
    if (!plate.is_shell(face.side)) continue;
    const double up = plate.parts.kinematics.area(face).z();
    plate.pair.sides[0] = ShellSides::both;
    n_both += plate.takes(face) ? 1 : 0;
    plate.pair.sides[0] = ShellSides::top;
    if (plate.takes(face)) CHECK(up > 0.5);
    n_top += plate.takes(face) ? 1 : 0;
    plate.pair.sides[0] = ShellSides::bottom;
    if (plate.takes(face)) CHECK(up < -0.5);
    n_bottom += plate.takes(face) ? 1 : 0;
  }
  CHECK(n_both == 6);
  CHECK(n_top == 1);
  CHECK(n_bottom == 1);
}

TEST_CASE("solids take part whatever sides are named, and sides are those of their own surface",
          "[contact][shell_sides]") {
  SidedPlate plate;
  plate.pair.sides = {ShellSides::both, ShellSides::top};
  for (const ContactFace& face : plate.parts.contact_mesh.faces) CHECK(plate.takes(face));
  for (const SurfaceNode& node : plate.parts.contact_mesh.surface_nodes) CHECK(plate.takes(node));
}

TEST_CASE("a node takes part where one of its faces does, one without faces always",
          "[contact][shell_sides]") {
  SidedPlate plate;
  plate.pair.sides[0] = ShellSides::top;
  for (const SurfaceNode& node : plate.parts.contact_mesh.surface_nodes) {
    const bool is_top = plate.parts.kinematics.x(node.node).z() > 0.0;
    CHECK(plate.takes(node) == is_top);
  }
  MeshBuilder b = SidedPlate::plate();
  add_balls(b, 3, {{5, 5, 5}}, 0.3);
  const ContactParts parts(b, general_contact());
  SurfacePair pair = parts.model.pairs[{0}];
  for (const SurfaceNode& node : parts.contact_mesh.surface_nodes) {
    if (!(node.radius > 0.0f)) continue;
    pair.first = node.surface;
    pair.sides[0] = ShellSides::bottom;
    CHECK(takes_part(pair, node, parts.contact_mesh, parts.mesh));
  }
}

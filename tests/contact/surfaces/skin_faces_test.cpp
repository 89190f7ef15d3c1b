// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/skin_faces.hpp"

#include <fmt/format.h>

#include "support/catch.hpp"
#include "support/contact_deck.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Elements 1, 2 hexahedra of block_1 along x, 3 one of block_2 behind them, 4, 5 beams of block_3.
/// surface_1: the faces 1:2 and 1:4, twice.
Mesh small_model() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 1, 1}, .size = {2, 1, 1}});
  b.add_hexes({.id = 2, .origin = {2, 0, 0}});
  b.add_beams({.id = 3, .cells = 2, .from = {0, 5, 0}, .to = {2, 5, 0}});
  b.add_side_set(1, "", {{{0}, 4}, {{0}, 2}, {{0}, 4}});
  return b.build();
}

SkinFaces candidates_of(const Mesh& mesh, const std::string& lines,
                        const std::vector<std::uint8_t>& alive = {}) {
  const ContactDefinition contact = parse_contact(lines);
  Diagnostics diagnostics;
  const auto requests = make_surface_requests(contact, {}, mesh, diagnostics);
  REQUIRE(diagnostics.empty());
  return make_skin_faces(requests, mesh, ContactDomain(mesh, contact.subdomain, alive));
}

/// Faces as "1:2", those that are not in the skin in brackets.
std::string list_faces(const SkinFaces& skin_faces) {
  std::string text;
  REQUIRE(skin_faces.faces.size() == skin_faces.is_exterior.size());
  for (std::size_t i = 0; i < skin_faces.faces.size(); ++i) {
    const ElementSide face = skin_faces.faces[i];
    const std::string name = fmt::format("{}:{}", face.element().value + 1, face.side());
    text += skin_faces.is_exterior[i] ? " " + name : " (" + name + ")";
  }
  return text;
}

}  // namespace

TEST_CASE("candidates are skin faces and side-set faces, ascending, each once", "[contact][skin_faces]") {
  const Mesh mesh = small_model();
  CHECK(list_faces(candidates_of(mesh, "contact surface s contains surface_1\n")) == " (1:2) (1:4)");
  CHECK(list_faces(candidates_of(mesh, "contact surface s contains block_1 surface_1\n")) ==
        " 1:1 (1:2) 1:3 1:4 1:5 1:6 2:1 2:2 2:3 2:5 2:6");
  const SkinFaces all = candidates_of(mesh, "skin all blocks = on\n");
  CHECK(list_faces(all) == " 1:1 1:3 1:4 1:5 1:6 2:1 2:3 2:5 2:6 3:1 3:2 3:3 3:5 3:6");
  CHECK(all.lofted == std::vector<ElementIndex>{{3}, {4}});
  CHECK(all.in_between == std::vector<std::uint32_t>{1, 1, 0});
}

TEST_CASE("surfaces of nodes have no candidates", "[contact][skin_faces]") {
  const SkinFaces none =
      candidates_of(small_model(), "contact node set n contains block_1 block_3 surface_1\n");
  CHECK(none.faces.empty());
  CHECK(none.lofted.empty());
}

TEST_CASE("the dead and what lies outside of the subdomain are no candidates", "[contact][skin_faces]") {
  const Mesh mesh = small_model();
  const std::string lines = "contact surface s contains block_1 block_2 block_3 surface_1\n";
  const SkinFaces living = candidates_of(mesh, lines, all_but(mesh, {1, 5}));
  CHECK(list_faces(living) == " 2:1 2:3 2:4 2:5 2:6 3:1 3:2 3:3 3:5 3:6");
  CHECK(living.lofted == std::vector<ElementIndex>{{3}});
  const SkinFaces near = candidates_of(
      mesh, lines + "restrict contact to subdomain defined by radius 0.8 and point 0 0.5 0.5\n");
  CHECK(list_faces(near) == " 1:4");
  CHECK(near.lofted.empty());
}

TEST_CASE("candidates are found by face, by element and by block", "[contact][skin_faces]") {
  const Mesh mesh = small_model();
  const SkinFaces all = candidates_of(mesh, "skin all blocks = on\n");
  CHECK(all.find_face(ElementSide({0}, 4)) == 2u);
  CHECK_FALSE(all.find_face(ElementSide({0}, 2)));
  CHECK_FALSE(all.find_face(ElementSide({3}, 1)));
  CHECK(all.find_lofted({4}) == 1u);
  CHECK_FALSE(all.find_lofted({0}));
  CHECK(all.faces_of(mesh.blocks()[0]) == std::pair(0u, 9u));
  CHECK(all.faces_of(mesh.blocks()[1]) == std::pair(9u, 14u));
  CHECK(all.faces_of(mesh.blocks()[2]) == std::pair(14u, 14u));
  CHECK(all.lofted_of(mesh.blocks()[0]) == std::pair(0u, 0u));
  CHECK(all.lofted_of(mesh.blocks()[2]) == std::pair(0u, 2u));
}

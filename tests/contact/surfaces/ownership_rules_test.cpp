// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/ownership_rules.hpp"

#include <fmt/format.h>

#include "support/catch.hpp"
#include "support/contact_deck.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Element 1 a hexahedron, 2 and 3 shells beside one another far from it, 4 a hexahedron that shares 1:2.
/// surface_1: 1:6, 1:2 twice; surface_2: the top of shell 3 and 1:1.
Mesh ruled_model() {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_shells({.id = 2, .cells = {2, 1}, .origin = {0, 0, 5}, .u = {2, 0, 0}});
  b.add_hexes({.id = 3, .origin = {1, 0, 0}});
  b.add_side_set(1, "", {{{0}, 6}, {{0}, 2}, {{0}, 6}});
  b.add_side_set(2, "", {{{2}, 1}, {{0}, 1}});
  return b.build();
}

/// The rules of some lines on that mesh.
struct Rules {
  explicit Rules(const std::string& lines) : contact(parse_contact(lines)), rules(make()) {}

  OwnershipRules make() const {
    Diagnostics diagnostics;
    auto requests = make_surface_requests(contact, {}, mesh, diagnostics);
    REQUIRE(diagnostics.empty());
    return {std::move(requests), mesh, contact.subdomain};
  }
  /// The owner, and "loser<winner" of each lost claim.
  static std::string list(const Claim& claim) {
    std::string text = claim.owner ? std::to_string(claim.owner->value) : "-";
    for (const Claim::Lost& lost : claim.lost)
      text += fmt::format(" {}<{}", lost.loser.value, lost.winner.value);
    return text;
  }
  std::string face(int side, bool is_exterior) const {
    return list(rules.of_face(ElementSide({0}, side), is_exterior));
  }
  std::string body(std::uint32_t element) const { return list(rules.of_lofted({element}).body); }

  Mesh mesh = ruled_model();
  ContactDefinition contact;
  OwnershipRules rules;
};

std::string block_form(const std::string& lines) { return "begin contact surface s\n" + lines + "end\n"; }

}  // namespace

TEST_CASE("blocks claim exterior faces, side sets claim theirs wherever they are", "[contact][ownership]") {
  const Rules of_block("contact surface s contains block_1\n");
  CHECK(of_block.face(2, true) == "0");
  CHECK(of_block.face(2, false) == "-");
  const Rules of_set("contact surface s contains surface_1\n");
  CHECK(of_set.face(2, false) == "0");
  CHECK(of_set.face(1, true) == "-");
}

TEST_CASE("the first request owns a face, later ones lose it to the owner", "[contact][ownership]") {
  const Rules rules(
      "contact surface a contains surface_1\n"
      "contact surface b contains block_1 surface_1\n"
      "contact node set n contains block_1\n"
      "contact surface c contains block_1\n");
  CHECK(rules.face(6, true) == "0 1<0 3<0");
  CHECK(rules.face(6, false) == "0 1<0");
  CHECK(rules.face(1, true) == "1 3<1");
}

TEST_CASE("a subset owns a face, its surface counts what is lost", "[contact][ownership]") {
  const Rules rules(
      block_form("block = block_1\nsubset up with normal 0 0 1\nsubset up2 with normal 0 0 1\n") +
      block_form("block = block_1\nsubset left with normal 0 0 1\n").replace(22, 1, "t") +
      "contact surface last contains block_1\n");
  CHECK(rules.face(6, true) == "1 3<1 5<1");  // s s_up s_up2 t t_left last
  CHECK(rules.face(1, true) == "0 3<0 5<0");
}

TEST_CASE("removed side sets take faces and shells out of one claim only", "[contact][ownership]") {
  const Rules rules(block_form("include all blocks\nremove surface = surface_2 surface_1\n") +
                    "contact surface rest contains block_1 block_2\n");
  CHECK(rules.face(6, true) == "1");
  CHECK(rules.face(3, true) == "0 1<0");
  CHECK(rules.body(1) == "0 1<0");
  CHECK(rules.body(2) == "1");
}

TEST_CASE("a shell and its sides in side sets have one owner", "[contact][ownership]") {
  const auto sides_of = [](const Rules& rules) {
    const LoftedClaim claim = rules.rules.of_lofted({2});
    REQUIRE(claim.sides == std::vector<ElementSide>{ElementSide({2}, 1)});
    return Rules::list(claim.of_sides[0]);
  };
  const Rules side_first("contact surface a contains surface_2\ncontact surface b contains block_2\n");
  CHECK(side_first.body(2) == "- 1<0");
  CHECK(sides_of(side_first) == "0");
  const Rules body_first("contact surface b contains block_2\ncontact surface a contains surface_2\n");
  CHECK(body_first.body(2) == "0");
  CHECK(sides_of(body_first) == "- 1<0");
  const Rules both("contact surface a contains surface_2 block_2\n");
  CHECK(both.body(2) == "0");
  CHECK(sides_of(both) == "-");
}

TEST_CASE("single elements are claimed once, however often they are named", "[contact][ownership]") {
  const Rules rules(block_form("element = 3 2 3\nblock = block_2\n") +
                    "contact surface b contains block_2\n");
  CHECK(rules.body(1) == "0 1<0");
  CHECK(rules.body(2) == "0 1<0");
  const Rules picked(block_form("element = 3\n"));
  CHECK(picked.body(1) == "-");
  CHECK(picked.body(2) == "0");
}

TEST_CASE("nothing outside of the subdomain is claimed", "[contact][ownership]") {
  const Rules rules(
      "contact surface s contains block_1 block_2\n"
      "restrict contact to subdomain defined by radius 2.3 and point 0 0.5 5\n");
  CHECK(rules.face(6, true) == "-");
  CHECK(rules.body(1) == "0");
  CHECK(rules.body(2) == "0");
}

TEST_CASE("present are the elements of skinned blocks and those picked", "[contact][ownership]") {
  using Marks = std::vector<std::uint8_t>;
  CHECK(Rules("contact surface s contains block_1 surface_2\n").rules.find_present() == Marks{1, 0, 0, 0});
  CHECK(Rules(block_form("block = block_3\nelement = 3\n")).rules.find_present() == Marks{0, 0, 1, 1});
  CHECK(Rules("contact node set n contains block_1\n").rules.find_present() == Marks{0, 0, 0, 0});
}

TEST_CASE("the sides of an element in side sets stand there once", "[contact][ownership]") {
  const Rules rules("contact surface s contains surface_1 surface_2\n");
  const ElementIndex hexahedron{0};
  CHECK(rules.rules.sides_of(hexahedron) ==
        std::vector<ElementSide>{{hexahedron, 1}, {hexahedron, 2}, {hexahedron, 6}});
  CHECK(rules.rules.sides_of({1}).empty());
  CHECK(rules.rules.sides().size() == 4);
}

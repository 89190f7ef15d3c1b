// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/contact_surface_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

template <class Made>
Made made_by(const std::string& lines) {
  const BoundContact bound = bound_contact(lines);
  CHECK(bound.messages == "");
  REQUIRE(bound.contact.surface_commands.size() == 1);
  return std::get<Made>(bound.contact.surface_commands[0]);
}

}  // namespace

TEST_CASE("the line forms take a name and items", "[parser][contact]") {
  const auto surface = made_by<ContactSurfaceLine>("contact surface s contains block_1, surface_2 asm\n");
  CHECK(surface.name.text == "s");
  CHECK(joined_names(surface.items) == "block_1 surface_2 asm");
  CHECK(to_string(surface.items[1].location) == "a.i:2:37");
  const auto nodes = made_by<ContactNodeSetLine>("contact node set n contains nodelist_1\n");
  CHECK(nodes.name.text == "n");
  CHECK(joined_names(nodes.items) == "nodelist_1");
}

TEST_CASE("CONTACTS for CONTAINS is an error with a hint", "[parser][contact]") {
  CHECK(bound_contact("contact surface x contacts y\n").messages ==
        "a.i:2:19: error: unknown word 'contacts'; did you mean 'contains'?\n");
  CHECK(bound_contact("contact surface x contians y\n").messages ==
        "a.i:2:19: error: expected 'contains' in 'contact surface', found 'contians'; did you mean "
        "'contains'?\n");
}

TEST_CASE("the block form takes all of its lines", "[parser][contact]") {
  const auto surface = made_by<ContactSurfaceBlock>(
      "begin contact surface s\ninclude all blocks\nblock = b1 b2\nelement = 12 15\nsurface = s1\nassembly = "
      "a\n"
      "remove block = b3\nremove surface = s2\nsubset xp with normal 1 0 0\nsubset ym with normal 0, -2, "
      "0\nend\n");
  CHECK(surface.name.text == "s");
  CHECK(surface.includes_all_blocks);
  CHECK(joined_names(surface.blocks) == "b1 b2");
  REQUIRE(surface.elements.size() == 2);
  CHECK(surface.elements[1].id == 15);
  CHECK(joined_names(surface.side_sets) == "s1");
  CHECK(joined_names(surface.assemblies) == "a");
  CHECK(joined_names(surface.removed_blocks) == "b3");
  CHECK(joined_names(surface.removed_side_sets) == "s2");
  REQUIRE(surface.subsets.size() == 2);
  CHECK(surface.subsets[1].name.text == "ym");
  CHECK(surface.subsets[1].normal == Eigen::Vector3d(0.0, -2.0, 0.0));
}

TEST_CASE("skin all blocks is off unless it says ON, and may exclude", "[parser][contact]") {
  CHECK(bound_contact("skin all blocks = off\n").contact.surface_commands.empty());
  CHECK(made_by<SkinAllBlocks>("skin all blocks = on\n").excluded.empty());
  CHECK(joined_names(made_by<SkinAllBlocks>("skin all blocks = on exclude b1 b2\n").excluded) == "b1 b2");
  CHECK(to_string(made_by<SkinAllBlocks>("contact all blocks\n").location) == "a.i:2:1");
}

TEST_CASE("surface commands keep the deck's order", "[parser][contact]") {
  const auto commands =
      bound_contact(
          "contact surface a contains b\nskin all blocks = on\nbegin contact surface c\nblock = b\nend\n"
          "contact node set d contains n\n")
          .contact.surface_commands;
  REQUIRE(commands.size() == 4);
  CHECK(std::holds_alternative<ContactSurfaceLine>(commands[0]));
  CHECK(std::holds_alternative<SkinAllBlocks>(commands[1]));
  CHECK(std::holds_alternative<ContactSurfaceBlock>(commands[2]));
  CHECK(std::holds_alternative<ContactNodeSetLine>(commands[3]));
}

TEST_CASE("contact can be restricted to a sphere once", "[parser][contact]") {
  const std::string line = "restrict contact to subdomain defined by radius 2.5 and point 1 2 3\n";
  const ContactSubdomain subdomain = bound_contact(line).contact.subdomain.value();
  const auto sphere = std::get<ContactSphere>(subdomain.shape);
  CHECK(sphere.radius == 2.5);
  CHECK(sphere.point == Eigen::Vector3d(1.0, 2.0, 3.0));
  CHECK(bound_contact("restrict contact to subdomain defined by radius 2.5 and point 1 2\n").messages ==
        "a.i:2:1: error: expected a number after 'restrict contact to subdomain defined by "
        "radius', found the end of the line\n");
  CHECK(bound_contact(line + line).messages.find("a second RESTRICT CONTACT in one contact definition") !=
        std::string::npos);
}

TEST_CASE("contact can be restricted to a box once, by any two opposite corners", "[parser][contact]") {
  const std::string line = "restrict contact to box defined by 1 5 -3 and 2 -4 0\n";
  const auto box = std::get<ContactBox>(bound_contact(line).contact.subdomain.value().shape);
  CHECK(box.lower == Eigen::Vector3d(1.0, -4.0, -3.0));
  CHECK(box.upper == Eigen::Vector3d(2.0, 5.0, 0.0));
  CHECK(bound_contact("restrict contact to box defined by 1 5 -3 to 2 -4 0\n").messages ==
        "a.i:2:43: error: expected 'and' in 'restrict contact to box defined by', found 'to'\n");
  CHECK(bound_contact("restrict contact to subdomain defined by radius 2.5 and point 1 2 3\n" + line)
            .messages.find(
                "a second RESTRICT CONTACT in one contact definition; the first stands at a.i:2:1") !=
        std::string::npos);
}

TEST_CASE("an analytic object is a plane with a normal", "[parser][contact]") {
  const BoundRegion bound = bound_region(
      "begin analytic object a\n type = plane\n normal direction = 0 0 2\n origin = 1 2 3\n scale factor = "
      "0.5\nend\n");
  CHECK(bound.messages == "");
  const AnalyticPlane& plane = bound.region.analytic_planes.at(0);
  CHECK(plane.name.text == "a");
  CHECK(plane.normal == Eigen::Vector3d(0.0, 0.0, 2.0));
  CHECK(plane.origin == Eigen::Vector3d(1.0, 2.0, 3.0));
  CHECK(plane.scale_factor == 0.5);
  CHECK(bound_region("begin analytic object a\n type = sphere\nend\n").messages ==
        "a.i:2:9: error: expected 'plane' in 'type', found 'sphere'\n");
}

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/lofting/loft_sizes.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/deck_dump.hpp"

// Where thicknesses and radii of lofted elements come from, and what is said when there is none.

using namespace contactsim;
using namespace contactsim::test;

namespace {

struct FoundSizes {
  std::vector<LoftSize> sizes;  ///< of all elements, in order
  std::string messages;
};

/// The sizes of all elements of a mesh, which belong to the surface "s" of line 4.
FoundSizes find_sizes(const Mesh& mesh, const std::string& definitions,
                      const std::string& contact_lines = "") {
  Region region;
  region.contact = parse_contact(contact_lines);
  SurfaceList surfaces(2);
  surfaces[{0}].name = "other";
  surfaces[{1}].name = "s";
  surfaces[{1}].location = {std::make_shared<const SourceFile>(SourceFile{"c.i", ""}), 4, 1, nullptr};
  std::vector<OwnedElement> owned;
  for (std::uint32_t e = 0; e < mesh.n_elements(); ++e) owned.push_back({{e}, {1}});
  Diagnostics diagnostics;
  FoundSizes found;
  found.sizes = find_loft_sizes(parse_definitions(definitions), region, mesh, {surfaces, owned}, diagnostics);
  found.messages = messages(diagnostics);
  return found;
}

/// Definitions in which the blocks have a section of this type with these lines.
std::string with_section(const std::string& type, const std::string& lines,
                         const std::string& blocks = "block_1") {
  return "begin " + type + " section sec\n" + lines + "\nend\n" +
         "begin finite element model m\n begin parameters for block " + blocks +
         "\n  section = sec\n end\nend\n";
}

Mesh one_shell() { return MeshBuilder().add_shells({.id = 1}).build(); }
Mesh one_beam() { return MeshBuilder().add_beams({.id = 1}).build(); }
Mesh one_bar() { return MeshBuilder().add_bars({.id = 1}).build(); }
Mesh one_particle() { return MeshBuilder().add_spheres(1, "", {{0, 0, 0}}).build(); }

/// One shell of 1 x 1 with attributes.
Mesh shell_with(const std::vector<std::string>& names, const std::vector<double>& values) {
  return MeshBuilder().add_shells({.id = 1}).set_attributes(1, names, values).build();
}

double thickness_of(const Mesh& mesh, const std::string& definitions, const std::string& contact = "") {
  const FoundSizes found = find_sizes(mesh, definitions, contact);
  INFO(found.messages);
  REQUIRE(found.messages.empty());
  return found.sizes.at(0).thickness;
}

double radius_of(const Mesh& mesh, const std::string& definitions, const std::string& contact = "") {
  const FoundSizes found = find_sizes(mesh, definitions, contact);
  INFO(found.messages);
  REQUIRE(found.messages.empty());
  return found.sizes.at(0).radius;
}

}  // namespace

TEST_CASE("a section of shells or membranes gives thickness, its factor and the lofting factor",
          "[contact][sizes]") {
  const std::string type = GENERATE(as<std::string>{}, "shell", "membrane");
  const auto plain = find_sizes(one_shell(), with_section(type, " thickness = 0.25"));
  REQUIRE(plain.messages.empty());
  CHECK(plain.sizes.at(0).thickness == 0.25);
  CHECK(plain.sizes.at(0).lofting_factor == 0.5);
  const auto scaled = find_sizes(
      one_shell(),
      with_section(type, " thickness = 0.25\n thickness scale factor = 3\n lofting factor = 0.125"));
  REQUIRE(scaled.messages.empty());
  CHECK(scaled.sizes.at(0).thickness == 0.75);
  CHECK(scaled.sizes.at(0).lofting_factor == 0.125);
}

TEST_CASE("a section's thickness goes before the mesh's attribute", "[contact][sizes]") {
  const Mesh mesh = shell_with({"thickness"}, {0.5});
  CHECK(thickness_of(mesh, with_section("shell", " thickness = 0.25")) == 0.25);
  CHECK(thickness_of(mesh, with_section("shell", " lofting factor = 1")) == 0.5);
  CHECK(thickness_of(mesh, "") == 0.5);
  CHECK(thickness_of(mesh, with_section("shell", " thickness scale factor = 3")) == 1.5);
}

TEST_CASE("the thickness attribute is found by its name, else it is the first", "[contact][sizes]") {
  CHECK(thickness_of(shell_with({"angle", "Thickness"}, {30, 0.5}), "") == 0.5);
  CHECK(thickness_of(shell_with({"a", "b"}, {0.125, 0.5}), "") == 0.125);
  CHECK(thickness_of(shell_with({"", ""}, {0.125, 0.5}), "") == 0.125);
}

TEST_CASE("a shell with one attribute per node has their mean as thickness", "[contact][sizes]") {
  CHECK(thickness_of(shell_with({"", "", "", ""}, {0.125, 0.25, 0.5, 0.125}), "") == 0.25);
  MeshBuilder b;
  b.add_triangles({.id = 1});
  b.set_attributes(1, {"t1", "t2", "t3"}, {1, 2, 6, 0.5, 0.5, 2});
  const auto found = find_sizes(b.build(), "");
  CHECK(found.sizes.at(0).thickness == 3.0);
  CHECK(found.sizes.at(1).thickness == 1.0);
}

TEST_CASE("a section may name the attribute that holds the thickness", "[contact][sizes]") {
  const std::string section = with_section("shell", " thickness mesh variable = Web");
  CHECK(thickness_of(shell_with({"thickness", "web"}, {0.5, 0.125}), section) == 0.125);
  // A file without attribute names cannot be asked for one.
  CHECK(thickness_of(shell_with({"", ""}, {0.5, 0.125}), section) == 0.5);
  CHECK(find_sizes(shell_with({"thickness", "wed"}, {0.5, 0.125}), section).messages ==
        "c.i:4:1: error: block 'block_1' (SHELL4) has no attribute 'Web' on the mesh, from which its section "
        "takes the thickness; it is in contact through surface 's'\n");
}

TEST_CASE("lines have an area and particles a radius as attribute", "[contact][sizes]") {
  MeshBuilder b;
  b.add_beams({.id = 1});
  b.set_attributes(1, {"i1", "AREA"}, {7, std::numbers::pi / 4});
  CHECK(radius_of(b.build(), "") == Approx(0.5).epsilon(1e-15));
  CHECK(radius_of(b.build(), with_section("beam", " section = bar")) == Approx(0.5).epsilon(1e-15));
  MeshBuilder dust;
  dust.add_spheres(1, "", {{0, 0, 0}, {1, 0, 0}});
  dust.set_attributes(1, {"volume", "radius"}, {9, 0.125, 9, 0.25});
  const auto found = find_sizes(dust.build(), "");
  CHECK(found.sizes.at(0).radius == 0.125);
  CHECK(found.sizes.at(1).radius == 0.25);
  CHECK(radius_of(dust.build(), with_section("particle", " radius = 2")) == 2.0);
}

TEST_CASE("a block without a size is one error, at the surface that has it", "[contact][sizes]") {
  MeshBuilder b;
  b.add_shells({.id = 1, .cells = {3, 2}});
  b.add_beams({.id = 2, .cells = 4});
  b.add_spheres(3, "dust", {{0, 5, 0}, {1, 5, 0}});
  const auto found = find_sizes(b.build(), with_section("solid", "", "block_1 block_2"));
  const auto message = [](const std::string& block, const std::string& what) {
    return "c.i:4:1: error: block " + block + " has no " + what +
           " to loft it with: neither a section nor an attribute on the mesh; it is in contact through "
           "surface 's'\n";
  };
  CHECK(found.messages == message("'block_1' (SHELL4)", "thickness") +
                              message("'block_2' (BEAM2)", "radius") + message("'dust' (SPHERE)", "radius"));
  REQUIRE(found.sizes.size() == 12);
  for (const LoftSize& size : found.sizes) CHECK(size.thickness + size.radius == 0.0);
}

TEST_CASE("a size that is not positive is an error with the element's id", "[contact][sizes]") {
  const auto error_of = [](double second) {
    MeshBuilder b;
    b.add_shells({.id = 1, .cells = {2, 1}});
    b.set_attributes(1, {"thickness"}, {0.5, second});
    b.set_element_ids({10, 20});
    return find_sizes(b.build(), "").messages;
  };
  const std::string text =
      "c.i:4:1: error: block 'block_1' (SHELL4) cannot be lofted: the thickness of element 20 is ";
  const std::string hint = "; it is in contact through surface 's'\n";
  CHECK(error_of(0.0) == text + "0" + hint);
  CHECK(error_of(-0.5) == text + "-0.5" + hint);
  CHECK(error_of(std::numeric_limits<double>::infinity()) == text + "inf" + hint);
  CHECK(error_of(std::numeric_limits<double>::quiet_NaN()) == text + "nan" + hint);
  CHECK(error_of(1e-300).empty());
  MeshBuilder b;
  b.add_beams({.id = 1});
  b.set_attributes(1, {"area"}, {-1});
  CHECK(find_sizes(b.build(), "").messages.find("cannot be lofted: the area of element 1 is -1;") !=
        std::string::npos);
}

TEST_CASE("BEAM RADIUS of SURFACE OPTIONS goes before the section, for its surfaces", "[contact][sizes]") {
  const std::string section = with_section("beam", " section = rod\n width = 0.5");
  const auto radius = [&](const std::string& contact) { return radius_of(one_beam(), section, contact); };
  const std::string options = "begin surface options\n beam radius = 2\n";
  CHECK(radius(options + "end\n") == 2.0);
  CHECK(radius(options + " surface = other S\nend\n") == 2.0);
  CHECK(radius(options + " surface = other\nend\n") == 0.25);
  CHECK(radius(options + " remove surface = S\nend\n") == 0.25);
  CHECK(radius(options + " remove surface = other\nend\n") == 2.0);
  CHECK(radius("begin surface options\nend\n") == 0.25);
  CHECK(radius_of(one_bar(), with_section("truss", " area = 3"), options + "end\n") == 2.0);
  // It is no radius of particles, and no thickness.
  CHECK(radius_of(one_particle(), with_section("particle", " radius = 3"), options + "end\n") == 3.0);
  CHECK(thickness_of(one_shell(), with_section("shell", " thickness = 3"), options + "end\n") == 3.0);
}

TEST_CASE("the last of several SURFACE OPTIONS that gives a beam radius counts", "[contact][sizes]") {
  const std::string two = "begin surface options\n beam radius = 2\nend\n",
                    three = "begin surface options\n surface = s\n beam radius = 3\nend\n",
                    shells = "begin surface options\n contact shell thickness = let_contact_choose\nend\n";
  CHECK(radius_of(one_beam(), "", two + three) == 3.0);
  CHECK(radius_of(one_beam(), "", three + two) == 2.0);
  CHECK(radius_of(one_beam(), "", two + shells) == 2.0);
}

TEST_CASE("LET_CONTACT_CHOOSE keeps the thickness between shares of the shortest edge", "[contact][sizes]") {
  // The shell is 4 x 0.5: by default 0.05 to 0.5.
  const Mesh mesh = MeshBuilder().add_shells({.id = 1, .u = {4, 0, 0}, .v = {0, 0.5, 0}}).build();
  const auto limited = [&](const std::string& thickness, const std::string& lines) {
    return thickness_of(
        mesh, with_section("shell", " thickness = " + thickness),
        "begin surface options\n contact shell thickness = let_contact_choose\n" + lines + "end\n");
  };
  CHECK(limited("0.01", "") == Approx(0.05).epsilon(1e-15));
  CHECK(limited("0.25", "") == 0.25);
  CHECK(limited("2", "") == 0.5);
  CHECK(limited("2", " allowable shell thickness = 0.5 to 2\n") == 1.0);
  CHECK(limited("0.125", " allowable shell thickness = 0.5 to 2\n") == 0.25);
  CHECK(limited("2", " surface = other\n") == 2.0);
  CHECK(thickness_of(mesh, with_section("shell", " thickness = 2"),
                     "begin surface options\n contact shell thickness = actual_thickness\nend\n") == 2.0);
}

TEST_CASE("edges without length do not limit the thickness", "[contact][sizes]") {
  // A quadrilateral that is degenerate to a triangle with legs of 1, and one that is a point.
  MeshBuilder b;
  b.add_node({0, 0, 0});
  b.add_node({1, 0, 0});
  b.add_node({0, 1, 0});
  b.add_block(1, "", Shape::shell4, {0, 1, 2, 2, 1, 1, 1, 1});
  const auto found =
      find_sizes(b.build(), with_section("shell", " thickness = 2"),
                 "begin surface options\n contact shell thickness = let_contact_choose\nend\n");
  REQUIRE(found.messages.empty());
  CHECK(found.sizes.at(0).thickness == 1.0);
  CHECK(found.sizes.at(1).thickness == 2.0);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/lofting/section_sizes.hpp"

#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/contact_deck.hpp"

// What sections say about sizes, and which section a block has.

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// The sizes of the blocks of a mesh under these definitions.
std::vector<SectionSize> sizes_of(const Mesh& mesh, const std::string& definitions) {
  return find_section_sizes(parse_definitions(definitions), Region{}, mesh);
}

/// The size of block_1 when it has a section of this type with these lines.
SectionSize size_of(const std::string& type, const std::string& lines) {
  const Mesh mesh = MeshBuilder().add_shells({.id = 1}).build();
  const auto sizes = sizes_of(mesh, "begin " + type + " section sec\n" + lines +
                                        "\nend\n"
                                        "begin finite element model m\n"
                                        " begin parameters for block block_1\n  section = sec\n end\nend\n");
  REQUIRE(sizes.size() == 1);
  return sizes[0];
}

double beam_radius(const std::string& lines) { return size_of("beam", lines).radius.value(); }

/// Definitions in which `names` have a shell section of thickness 0.25; block_7 is also called sheet, the
/// assembly outer hull.
std::string with_thickness(const std::string& names) {
  return "begin shell section sec\n thickness = 0.25\nend\n"
         "begin finite element model m\n"
         " alias block_7 as sheet\n"
         " alias outer as hull\n"
         " begin parameters for block " +
         names + "\n  section = sec\n end\nend\n";
}

}  // namespace

TEST_CASE("sections of shells and membranes give what lofting needs", "[contact][sizes]") {
  const std::string type = GENERATE(as<std::string>{}, "shell", "membrane");
  const SectionSize size = size_of(type,
                                   " thickness = 2\n thickness scale factor = 3\n lofting factor = 0.25\n"
                                   " thickness mesh variable = Web");
  CHECK(size.thickness == 2.0);
  CHECK(size.thickness_factor == 3.0);
  CHECK(size.lofting_factor == 0.25);
  CHECK(size.attribute == "Web");
  CHECK_FALSE(size.radius);
  CHECK_FALSE(size_of(type, "").thickness);
}

TEST_CASE("the cross-section of a beam is enclosed in a circle", "[contact][sizes]") {
  // Round shapes: half the larger diameter. Others: half the diagonal, 0.3-0.4-0.5.
  CHECK(beam_radius(" section = rod\n width = 0.5") == 0.25);
  CHECK(beam_radius(" section = rod\n width = 0.5\n height = 0.75") == 0.375);
  CHECK(beam_radius(" section = tube\n height = 0.5\n wall thickness = 0.01") == 0.25);
  CHECK(beam_radius(" section = bar\n width = 0.3\n height = 0.4") == Approx(0.25).epsilon(1e-15));
  CHECK(beam_radius(" section = box\n width = 0.3\n height = 0.4\n wall thickness = 0.01") ==
        Approx(0.25).epsilon(1e-15));
  CHECK(beam_radius(" section = i\n width = 0.4\n height = 0.3\n wall thickness = 0.01\n"
                    " flange thickness = 0.01") == Approx(0.25).epsilon(1e-15));
  CHECK(beam_radius(" section = bar\n width = 2") == Approx(std::sqrt(2.0)).epsilon(1e-15));  // a square
  CHECK_FALSE(size_of("beam", " section = bar").radius);
}

TEST_CASE("a truss becomes a cylinder of its area, a particle a sphere", "[contact][sizes]") {
  CHECK(size_of("truss", " area = 3").radius.value() ==
        Approx(std::sqrt(3 / std::numbers::pi)).epsilon(1e-15));
  CHECK_FALSE(size_of("truss", "").radius);
  CHECK(size_of("particle", " radius = 3").radius == 3.0);
  CHECK_FALSE(size_of("particle", "").radius);
}

TEST_CASE("other sections give no size", "[contact][sizes]") {
  const std::string type = GENERATE(as<std::string>{}, "solid", "point mass", "cohesive");
  const SectionSize size = size_of(type, "");
  CHECK_FALSE(size.thickness);
  CHECK_FALSE(size.radius);
}

TEST_CASE("a block takes the section of any name that it has", "[contact][sizes]") {
  MeshBuilder b;
  b.add_shells({.id = 7, .name = "Skin Plate"});
  b.add_shells({.id = 8});
  b.add_assembly(1, "outer", EntityKind::block, {7});
  b.add_assembly(2, "all", EntityKind::assembly, {1});
  const Mesh mesh = b.build();
  const std::string name =
      GENERATE(as<std::string>{}, "skin_plate", "BLOCK_7", "outer", "all", "assembly_2", "sheet", "Hull");
  const auto sizes = sizes_of(mesh, with_thickness(name));
  REQUIRE(sizes.size() == 2);
  CHECK(sizes[0].thickness == 0.25);
  CHECK_FALSE(sizes[1].thickness);
}

TEST_CASE("a side set that has a block's name gives it no section", "[contact][sizes]") {
  MeshBuilder b;
  b.add_shells({.id = 7});
  b.add_side_set(7, "outer", {{{0}, 1}});
  CHECK_FALSE(sizes_of(b.build(), with_thickness("hull")).at(0).thickness);
}

TEST_CASE("parameters that name a block go before those of all blocks", "[contact][sizes]") {
  MeshBuilder b;
  for (const std::int64_t id : {1, 2, 3}) b.add_shells({.id = id});
  const auto sizes = sizes_of(b.build(),
                              "begin shell section thin\n thickness = 1\nend\n"
                              "begin shell section thick\n thickness = 2\nend\n"
                              "begin finite element model m\n"
                              " begin parameters for block\n"
                              "  include all blocks\n  remove block = block_3\n  section = thin\n"
                              " end\n"
                              " begin parameters for block block_2\n  section = thick\n end\n"
                              "end\n");
  CHECK(sizes.at(0).thickness == 1);
  CHECK(sizes.at(1).thickness == 2);
  CHECK_FALSE(sizes.at(2).thickness);
}

TEST_CASE("without a finite element model there are no sections", "[contact][sizes]") {
  const Mesh mesh = MeshBuilder().add_shells({.id = 1}).build();
  const auto sizes = sizes_of(mesh, "begin shell section sec\n thickness = 0.25\nend\n");
  REQUIRE(sizes.size() == 1);
  CHECK_FALSE(sizes[0].thickness);
}

TEST_CASE("the region's own finite element model counts", "[contact][sizes]") {
  const Mesh mesh = MeshBuilder().add_shells({.id = 1}).build();
  std::string definitions;
  for (const std::string name : {"1", "2"}) {
    definitions += "begin shell section s" + name + "\n thickness = " + name +
                   "\nend\n"
                   "begin finite element model m" +
                   name + "\n begin parameters for block block_1\n  section = s" + name + "\n end\nend\n";
  }
  Region region = parse_region("use finite element model M2\n");
  CHECK(find_section_sizes(parse_definitions(definitions), region, mesh).at(0).thickness == 2.0);
}

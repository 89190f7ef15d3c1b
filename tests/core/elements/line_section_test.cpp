// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/line_section.hpp"

#include "core/elements/elements.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Three trusses (ids 31 to 33) with areas and lengths, two particles (34, 35) with radii, a hexahedron.
Mesh thin_blocks(double area = 0.2) {
  MeshBuilder b;
  b.add_bars({.id = 1, .cells = 3}).set_attributes(1, {"i1", "Area"}, {9, 0.1, 9, area, 9, 0.3});
  b.add_spheres(2, "dust", {{5, 0, 0}, {6, 0, 0}}).set_attributes(2, {""}, {0.5, 0.6});
  b.add_hexes({.id = 3, .origin = {0, 5, 0}});
  b.add_bars({.id = 4, .from = {0, 9, 0}, .to = {1, 9, 0}});
  b.set_element_ids({31, 32, 33, 34, 35, 36, 37});
  return b.build();
}

struct LineMade {
  std::optional<LineSetup> setup;
  std::string messages;
};

LineMade setup_of(const std::optional<SectionProperties>& properties, std::uint32_t block,
                  const Mesh& mesh = thin_blocks()) {
  Diagnostics diagnostics;
  const SectionDefinition section{{"s", {}}, {}, properties.value_or(SolidSection{})};
  LineMade made{make_line_setup(properties ? &section : nullptr, mesh, block, {}, diagnostics), ""};
  made.messages = messages(diagnostics);
  return made;
}

}  // namespace

TEST_CASE("trusses and particles take their sizes from the section, else from the mesh", "[core][beams]") {
  const LineMade given = setup_of(TrussSection{0.7, 5.0, 2.0}, 0);
  REQUIRE(given.setup);
  CHECK(given.setup->element == &bar2_truss);
  CHECK(given.setup->sizes == std::vector<double>{0.7, 0.7, 0.7});
  CHECK(given.setup->preload.load == 5.0);
  CHECK(given.setup->preload.period == 2.0);
  CHECK(given.setup->beam.fibres.size() == 1);
  const LineMade of_mesh = setup_of(TrussSection{}, 0);
  REQUIRE(of_mesh.setup);
  CHECK(of_mesh.setup->sizes == std::vector<double>{0.1, 0.2, 0.3});
  const LineMade dust = setup_of(ParticleSection{}, 1);
  REQUIRE(dust.setup);
  CHECK(dust.setup->element == &sphere_particle);
  CHECK(dust.setup->sizes == std::vector<double>{0.5, 0.6});
  REQUIRE(setup_of(std::nullopt, 1).setup);  // particles may do without a section
  CHECK(setup_of(std::nullopt, 1).setup->sizes == std::vector<double>{0.5, 0.6});
}

TEST_CASE("a beam has the area of its shape", "[core][beams]") {
  BeamSection beam;
  beam.shape = BeamShape::bar;
  beam.width = 0.1;
  beam.height = 0.3;
  const LineMade made = setup_of(beam, 0);
  REQUIRE(made.setup);
  CHECK(made.setup->element == &bar2_beam);
  REQUIRE(made.setup->sizes.size() == 3);
  CHECK(made.setup->sizes[2] == Approx(0.03));
  beam.height.reset();
  CHECK(setup_of(beam, 0).messages == "error: block_1: its beam section needs HEIGHT\n");
}

TEST_CASE("sizes that lack or are wrong are reported with the element's id", "[core][beams]") {
  CHECK(setup_of(TrussSection{}, 3).messages ==
        "error: block_4 has no area: neither a section nor an attribute on the mesh\n");
  CHECK(setup_of(TrussSection{}, 0, thin_blocks(-0.2)).messages ==
        "error: block_1: the area of its element 32 is -0.2\n");
  CHECK(setup_of(TrussSection{}, 0, thin_blocks(std::numeric_limits<double>::infinity())).messages ==
        "error: block_1: the area of its element 32 is inf\n");
  CHECK(setup_of(TrussSection{}, 0, thin_blocks(std::nan(""))).messages ==
        "error: block_1: the area of its element 32 is nan\n");
}

TEST_CASE("sections that are not for lines, particles or the shape are reported", "[core][beams]") {
  CHECK(setup_of(std::nullopt, 0).messages ==
        "error: block_1 has elements of type BAR2, which need a BEAM, TRUSS, SPRING or DAMPER SECTION\n");
  CHECK(setup_of(ShellSection{}, 1).messages ==
        "error: dust has elements of type SPHERE, which need a PARTICLE or POINT MASS SECTION\n");
  CHECK(setup_of(ParticleSection{0.1}, 0).messages ==
        "error: block_1 has elements of type BAR2, which its particle section is not for\n");
  CHECK(setup_of(TrussSection{0.1}, 1).messages ==
        "error: dust has elements of type SPHERE, which its truss section is not for\n");
}

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/output/surface_summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>

#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/random_contact.hpp"

// Areas are sums of a few products of numbers of order 1: 1e-12 is generous for their round-off.

using namespace contactsim;
using namespace contactsim::test;

namespace {

Approx near(double value) { return Approx(value).epsilon(1e-12); }

/// The summary of the surface with that position.
SurfaceSummary summary_of(const Mesh& mesh, const std::string& lines, std::size_t surface = 0,
                          std::span<const std::uint8_t> alive = {}) {
  const auto model = make_model(mesh, lines, "", alive);
  INFO(model.messages);
  REQUIRE(model.messages.empty());
  return summarize(model, mesh).at(surface);
}

/// Rows of the face table, one a line: "surface block element side kind".
std::string list_rows(const ContactModel& model, const std::vector<FacetRow>& rows) {
  std::string text;
  for (const FacetRow& row : rows) {
    text += fmt::format("{} {} {} {} {}\n", model.surfaces.surfaces[row.surface].name, row.block, row.element,
                        row.side, row.kind);
  }
  return text;
}

/// One hexahedron (element 1), a strip of two shells 0.2 thick (2, 3), a chain of two beams of radius 0.5 (4,
/// 5) and a particle of radius 0.25 (6).
MeshBuilder every_kind() {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_shells({.id = 2, .name = "strip", .cells = {2, 1}, .origin = {0, 0, 5}, .u = {2, 0, 0}});
  b.add_beams({.id = 3, .cells = 2, .from = {0, 7, 0}, .to = {4, 7, 0}});
  b.add_spheres(4, "", {{0, 9, 0}});
  b.set_attributes(2, {"thickness"}, {0.2, 0.2});
  b.set_attributes(3, {"area"}, {std::numbers::pi / 4, std::numbers::pi / 4});
  b.set_attributes(4, {"radius"}, {0.25});
  return b;
}

}  // namespace

TEST_CASE("a skin is counted by faces, nodes and area", "[contact][summary]") {
  // 2 x 3 x 4 unit cells: 60 nodes, 1 * 2 * 3 of them inside.
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1, .cells = {2, 3, 4}, .size = {2, 3, 4}}).build();
  const SurfaceSummary s = summary_of(mesh, "skin all blocks = on\n");
  CHECK(s.claimed == 52);
  CHECK(s.owned == 52);
  CHECK(s.quadrilaterals == 52);
  CHECK(s.triangles == 0);
  CHECK(s.nodes == 54);
  CHECK(s.area == near(52));
  CHECK(s.lofted_elements == 0);
}

TEST_CASE("triangles and quadrilaterals are distinguished", "[contact][summary]") {
  // Two wedges fill a cube: its top and bottom are two triangles each.
  const Mesh mesh = MeshBuilder().add_wedges({.id = 1, .size = {1, 2, 3}}).build();
  const SurfaceSummary s = summary_of(mesh, "skin all blocks = on\n");
  CHECK(s.triangles == 4);
  CHECK(s.quadrilaterals == 4);
  CHECK(s.owned == 8);
  CHECK(s.nodes == 8);
  CHECK(s.area == near(22));  // 2 (1*2 + 2*3 + 1*3)
}

TEST_CASE("faces of degenerate hexahedra count as what they are", "[contact][summary]") {
  // A hexahedron whose edges 0-3 and 4-7 have no length: a wedge. The place of the repeated node varies.
  MeshBuilder b;
  for (const double z : {0.0, 1.0}) {
    for (const Eigen::Vector2d& x : {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)})
      b.add_node({x.x(), x.y(), z});
  }
  const bool is_turned = GENERATE(false, true);
  b.add_block(1, "", Shape::hex8,
              is_turned ? std::vector<std::uint32_t>{0, 1, 1, 2, 3, 4, 4, 5}
                        : std::vector<std::uint32_t>{0, 1, 2, 0, 3, 4, 5, 3});
  const SurfaceSummary s = summary_of(b.build(), "skin all blocks = on\n");
  CHECK(s.triangles == 2);
  CHECK(s.quadrilaterals == 3);
  CHECK(s.nodes == 6);
  CHECK(s.area == near(3 + std::sqrt(2.0)));  // 2 halves, 2 sides of 1, the long side
}

TEST_CASE("what is claimed is what is owned and what is lost", "[contact][summary]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_side_set(1, "", {{{0}, 6}, {{0}, 2}});
  const Mesh mesh = b.build();
  const std::string lines =
      "contact surface a contains surface_1\n"
      "contact surface b contains block_1\n"
      "contact surface c contains surface_1\n";
  const SurfaceSummary second = summary_of(mesh, lines, 1), third = summary_of(mesh, lines, 2);
  CHECK(second.claimed == 6);
  CHECK(second.owned == 4);
  CHECK(second.nodes == 8);  // all corners, though two faces are gone
  CHECK(third.claimed == 2);
  CHECK(third.owned == 0);
  CHECK(third.nodes == 0);
  CHECK(third.area == 0.0);
}

TEST_CASE("lofts of shells are counted by elements and by facets", "[contact][summary]") {
  // 2 x 1 cells of 1 x 1: 6 edges on the perimeter. Areas: 2 tops and 2 bottoms of 1, 6 sides of 0.2.
  const SurfaceSummary s = summary_of(every_kind().build(), "contact surface s contains strip\n");
  CHECK(s.lofted_elements == 2);
  CHECK(s.top == 2);
  CHECK(s.bottom == 2);
  CHECK(s.side == 6);
  CHECK(s.prisms == 0);
  CHECK(s.nodes == 6);
  CHECK(s.area == near(5.2));
  CHECK(s.owned + s.claimed + s.triangles + s.quadrilaterals == 0);
}

TEST_CASE("lofts of lines and particles are counted by bodies", "[contact][summary]") {
  // A hexagon in a circle of 1/2 has edges of 1/2 and the area 3/8 sqrt(3); the chain is 4 long.
  const Mesh mesh = every_kind().build();
  const SurfaceSummary beams = summary_of(mesh, "contact surface s contains block_3\n");
  CHECK(beams.lofted_elements == 2);
  CHECK(beams.prisms == 2);
  CHECK(beams.nodes == 3);
  CHECK(beams.area == near(6 * 0.5 * 4 + 0.75 * std::sqrt(3.0)));
  const SurfaceSummary dust = summary_of(mesh, "contact surface s contains block_4\n");
  CHECK(dust.lofted_elements == 1);
  CHECK(dust.spheres == 1);
  CHECK(dust.nodes == 1);
  CHECK(dust.area == near(std::numbers::pi / 4));
}

TEST_CASE("nodes that faces and lofts share count once", "[contact][summary]") {
  // A shell on the cube's top shares its four nodes, the beam one of them.
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_shells({.id = 2, .origin = {0, 0, 1}});
  b.add_beams({.id = 3, .from = {1, 1, 1}, .to = {2, 2, 2}});
  b.set_attributes(2, {"thickness"}, {0.5});
  b.set_attributes(3, {"area"}, {1});
  const SurfaceSummary s = summary_of(b.build(), "contact surface s contains block_1 block_2 block_3\n");
  CHECK(s.owned == 5);
  CHECK(s.nodes == 9);
  CHECK(s.lofted_elements == 2);
}

TEST_CASE("a surface of nodes has nodes and nothing else", "[contact][summary]") {
  const SurfaceSummary s = summary_of(every_kind().build(), "contact node set n contains block_1 block_2\n");
  CHECK(s.nodes == 14);
  CHECK(s.area == 0.0);
  CHECK(s.owned + s.claimed + s.lofted_elements + s.top + s.prisms + s.spheres == 0);
}

TEST_CASE("death changes the figures of its surface only", "[contact][summary][death]") {
  const Mesh mesh = every_kind().build();
  const auto alive = all_but(mesh, {2});
  const SurfaceSummary strip = summary_of(mesh, "skin all blocks = on\n", 1, alive);
  CHECK(strip.lofted_elements == 1);
  CHECK(strip.side == 4);
  CHECK(strip.nodes == 4);
  CHECK(strip.area == near(2.8));
  CHECK(summary_of(mesh, "skin all blocks = on\n", 0, alive).area == near(6));
}

TEST_CASE("the face table lists what surfaces own, by surface, block, element and side",
          "[contact][summary]") {
  // The deck's order goes before the mesh's, the mesh's before that of ids.
  MeshBuilder b = every_kind();
  b.add_node_set(9, "", {2, 0});
  b.set_element_ids({60, 50, 40, 30, 20, 10});
  const Mesh mesh = b.build();
  const auto model = make_model(mesh,
                                "contact node set n contains nodelist_9\n"
                                "contact surface s contains block_4 block_3 block_2\n"
                                "contact surface t contains block_1\n");
  REQUIRE(model.messages.empty());
  const auto rows = list_facets(model, mesh);
  CHECK(list_rows(model, rows) ==
        "n  1 0 node\n"
        "n  3 0 node\n"
        "s strip 40 1 top\n"
        "s strip 40 2 bottom\n"
        "s strip 40 3 side\n"
        "s strip 40 4 side\n"
        "s strip 40 5 side\n"
        "s strip 50 1 top\n"
        "s strip 50 2 bottom\n"
        "s strip 50 3 side\n"
        "s strip 50 5 side\n"
        "s strip 50 6 side\n"
        "s block_3 20 1 prism\n"
        "s block_3 30 1 prism\n"
        "s block_4 10 1 sphere\n"
        "t block_1 60 1 face\n"
        "t block_1 60 2 face\n"
        "t block_1 60 3 face\n"
        "t block_1 60 4 face\n"
        "t block_1 60 5 face\n"
        "t block_1 60 6 face\n");
  CHECK(rows[0].area == 0.0);
  CHECK(rows[2].area == near(1));
  CHECK(rows[4].area == near(0.2));
  CHECK(rows[12].area == near(6 + 0.375 * std::sqrt(3.0)));  // six sides of 0.5 x 2 and the free end
  CHECK(rows[14].area == near(std::numbers::pi / 4));
  CHECK(rows[15].area == near(1));
}

TEST_CASE("the face table shows a plane by its name", "[contact][summary]") {
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1}).build();
  const auto model = make_model(mesh, parse_region("begin analytic object Floor\n"
                                                   " normal direction = 0 0 1\nend\n"
                                                   "begin contact definition\n"
                                                   " contact surface ground contains floor block_1\nend\n"));
  REQUIRE(model.messages.empty());
  const auto rows = list_facets(model, mesh);
  REQUIRE(rows.size() == 7);
  CHECK(list_rows(model, {rows[0]}) == "ground Floor 0 0 analytic\n");
  CHECK(rows[0].area == 0.0);
}

TEST_CASE("the face table and the summary agree on random decks", "[contact][summary][properties]") {
  Random random(7);
  for (int round = 0; round < 10; ++round) {
    MeshBuilder b = random_mesh(random);
    b.set_attributes(6, {"thickness"}, std::vector<double>(6, 0.01));
    b.set_attributes(7, {"area"}, std::vector<double>(3, 0.01));
    const Mesh mesh = b.build();
    const auto model = make_model(mesh, join(random_lines(random)));
    REQUIRE(model.messages.empty());
    const auto summaries = summarize(model, mesh);
    REQUIRE(summaries.size() == model.surfaces.surfaces.size());
    IndexedVector<SurfaceIndex, std::map<std::string_view, std::uint32_t>> counts(summaries.size());
    IndexedVector<SurfaceIndex, double> areas(summaries.size(), 0.0);
    for (const FacetRow& row : list_facets(model, mesh)) {
      ++counts[row.surface][row.kind];
      areas[row.surface] += row.area;
    }
    for (const SurfaceIndex i : indices(summaries)) {
      const SurfaceSummary& s = summaries[i];
      CHECK(counts[i]["face"] == s.owned);
      CHECK(s.owned == s.triangles + s.quadrilaterals);
      CHECK(counts[i]["top"] == s.top);
      CHECK(counts[i]["bottom"] == s.bottom);
      CHECK(counts[i]["side"] == s.side);
      CHECK(counts[i]["prism"] == s.prisms);
      CHECK(counts[i]["node"] == model.surfaces.surfaces[i].nodes.size());
      CHECK(areas[i] == Approx(s.area).epsilon(1e-12));
    }
  }
}

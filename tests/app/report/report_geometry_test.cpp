// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/report_geometry.hpp"

#include <algorithm>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"
#include "support/report_region.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two cubes of 2 x 2 x 2 that share nodes, a shell on a quarter of the top of the second, a beam and a
/// particle; the top of the first is the side set "top".
Mesh make_mesh() {
  MeshBuilder builder;
  builder.add_hexes({.id = 1, .name = "left", .cells = {2, 2, 2}})
      .add_hexes({.id = 2, .name = "right", .cells = {2, 2, 2}, .origin = {1, 0, 0}})
      .add_shells({.id = 3, .name = "sheet", .origin = {1, 0, 1}, .u = {0.5, 0, 0}, .v = {0, 0.5, 0}})
      .add_beams({.id = 4, .name = "rod", .from = {0, 0, 3}, .to = {1, 0, 3}})
      .add_spheres(5, "grain", {{0, 0, 5}})
      .add_side_set(7, "top",
                    [](const CandidateSide& at) { return at.block_id == 1 && at.centroid.z() == 1.0; });
  return builder.build();
}

constexpr const char* patch_first =
    "begin contact definition\ncontact surface patch contains top\nskin all blocks = on\nend";

std::size_t count_owned(const ReportGeometry& geometry, const std::string& name) {
  const auto at = std::ranges::find(geometry.owners, name);
  REQUIRE(at != geometry.owners.end());
  const auto owner = static_cast<std::uint32_t>(at - geometry.owners.begin()) + 1;
  return static_cast<std::size_t>(std::ranges::count(geometry.faces, owner, &ReportFace::owner));
}

}  // namespace

TEST_CASE("particles and lines have the radius of their section", "[app][report]") {
  const Mesh mesh = make_mesh();
  SimulationDefinition deck = deck_of_region(patch_first);
  ParticleSection grains;
  grains.radius = 0.25;
  SectionDefinition section;
  section.name.text = "grains";
  section.properties = grains;
  deck.sections.push_back(section);
  FiniteElementModel& model = deck.finite_element_models.front();
  BlockParameters& parameters = model.block_parameters.emplace_back();
  parameters.names.push_back({"grain", {}});
  parameters.section = DeckName{"grains", {}};
  const ReportGeometry geometry = make_report_geometry(mesh, ReportRegion{deck, region_of(deck)}, {});
  CHECK(geometry.radii == std::vector<double>{0, 0, 0, 0, 0.25});
  CHECK(make_report_geometry(mesh, std::nullopt, {}).radii == std::vector<double>(5, 0.0));
}

TEST_CASE("the skin of all elements is drawn, each face once and with its owner", "[app][report]") {
  const Mesh mesh = make_mesh();
  const SimulationDefinition deck = deck_of_region(patch_first);
  const ReportGeometry geometry = make_report_geometry(mesh, ReportRegion{deck, region_of(deck)}, {});
  // 2 x 24 less 2 x 4 between the cubes; the shell hides one and is drawn
  CHECK(geometry.faces.size() == 40);
  CHECK(count_owned(geometry, "patch") == 4);
  CHECK(count_owned(geometry, "left") == 16);
  CHECK(count_owned(geometry, "right") == 19);
  CHECK(count_owned(geometry, "sheet") == 1);
  REQUIRE(geometry.lines.size() == 1);
  CHECK(geometry.owners[geometry.lines.front().owner - 1] == "rod");
  REQUIRE(geometry.particles.size() == 1);
  CHECK(geometry.owners[geometry.particles.front().owner - 1] == "grain");
  CHECK(geometry.particles.front().block == 4);
  const auto is_known = [&](std::uint32_t point) { return point < geometry.nodes.size(); };
  for (const ReportFace& face : geometry.faces) CHECK(std::ranges::all_of(face.points, is_known));
  // the node within each cube and that within their joint are not drawn; the others are, each once
  CHECK(geometry.nodes.size() == mesh.n_nodes() - 3);
}

TEST_CASE("a face knows who claimed it in vain", "[app][report]") {
  const Mesh mesh = make_mesh();
  const SimulationDefinition deck = deck_of_region(patch_first);
  const ReportGeometry geometry = make_report_geometry(mesh, ReportRegion{deck, region_of(deck)}, {});
  CHECK(geometry.knows_claims);
  std::size_t n_lost = 0;
  for (const ReportFace& face : geometry.faces) {
    const auto& lost = geometry.lost[face.claims];
    if (lost.empty()) continue;
    ++n_lost;
    REQUIRE(lost.size() == 1);
    CHECK(geometry.owners[lost.front().first] == "left");
    CHECK(geometry.owners[lost.front().second] == "patch");
    CHECK(geometry.owners[face.owner - 1] == "patch");
  }
  CHECK(n_lost == 4);
}

TEST_CASE("without a deck the side sets contact_<surface> are the owners", "[app][report]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 1, .name = "cube", .cells = {1, 1, 1}})
      .add_side_set(1, "other", [](const CandidateSide& at) { return at.normal.x() > 0.5; })
      .add_side_set(2, "contact_lid", [](const CandidateSide& at) { return at.normal.z() > 0.5; });
  const ReportGeometry geometry = make_report_geometry(builder.build(), std::nullopt, {});
  CHECK_FALSE(geometry.knows_claims);
  CHECK(geometry.owners == std::vector<std::string>{"lid"});
  CHECK(count_owned(geometry, "lid") == 1);
  CHECK(geometry.faces.size() == 6);
}

TEST_CASE("faces that deaths expose are drawn from then on, dead ones no more, and both have owners",
          "[app][report]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 1, .name = "bar", .cells = {2, 1, 1}});
  const Mesh mesh = builder.build();
  StoredVariables stored;
  stored.times = {0.0, 1.0, 2.0};
  stored.element.names = {"gone"};
  stored.element.read = [](std::size_t, std::size_t time) {
    return std::vector<double>{1.0, time < 1 ? 1.0 : 0.0};
  };
  const SimulationDefinition deck = deck_of_region(
      "begin results output\ndatabase name = r.e\nelement death_status as gone\nend\n"
      "begin contact definition\nskin all blocks = on\nend");
  const ElementLife life = find_element_life(stored, mesh, StoredNames(region_of(deck)));
  CHECK(life.dead_from == std::vector<std::uint32_t>{3, 1});
  REQUIRE(life.exposed.size() == 1);
  CHECK(life.exposed.begin()->first.element() == ElementIndex{0});
  const ReportGeometry geometry = make_report_geometry(mesh, ReportRegion{deck, region_of(deck)}, life);
  CHECK(geometry.faces.size() == 11);
  CHECK(count_owned(geometry, "bar") == 11);
  for (const ReportFace& face : geometry.faces) {
    CHECK(face.hidden_from == (face.element.value == 0 ? 3u : 1u));
    const bool is_between = face.element.value == 0 && life.exposed.contains({face.element, face.side});
    CHECK(face.shown_from == (is_between ? 1u : 0u));
  }
  CHECK(find_element_life(stored, mesh, {}).dead_from.empty());
}

TEST_CASE("a deck whose names the mesh does not have is refused", "[app][report]") {
  const SimulationDefinition deck =
      deck_of_region("begin contact definition\ncontact surface a contains nobody\nend");
  CHECK_THROWS_AS(make_report_geometry(make_mesh(), ReportRegion{deck, region_of(deck)}, {}), DeckError);
}

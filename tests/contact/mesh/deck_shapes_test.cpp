// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/deck_shapes.hpp"

#include "core/base/diagnostics.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// What a SURFACE SMOOTHING block gives to two cubes, the surfaces a and b.
struct GivenShapes {
  Diagnostics diagnostics;
  SmoothingShapes shapes;

  explicit GivenShapes(const std::string& lines, const std::string& definitions = "")
      : shapes(make(lines, definitions, diagnostics)) {}
  static SmoothingShapes make(const std::string& lines, const std::string& definitions,
                              Diagnostics& diagnostics) {
    MeshBuilder b;
    b.add_hexes({.id = 1});
    b.add_hexes({.id = 2, .origin = {5, 0, 0}});
    const Mesh mesh = b.build();
    const std::string surfaces = "contact surface a contains block_1\ncontact surface b contains block_2\n";
    const ContactDefinition contact =
        parse_contact(surfaces + "begin surface smoothing S\n" + lines + "end\n");
    return shapes_of_deck(contact.smoothings.at(0), make_model(mesh, surfaces),
                          parse_definitions(definitions), diagnostics);
  }
  const RoundShape& of(std::uint32_t surface) const { return shapes.surfaces[{surface}].given.at(0); }
  bool has(std::uint32_t surface) const { return !shapes.surfaces[{surface}].is_empty(); }
};

const std::string places =
    "define point low with coordinates 1 2 3\ndefine point high with coordinates 1 2 7\n"
    "define direction down with vector 0 0 -100\n"
    "define axis by_points with point low point high\n"
    "define axis by_direction with point low direction down\n";

}  // namespace

TEST_CASE("an axis runs through its points, or along its direction, and is of length 1",
          "[contact][smoothing]") {
  const std::string axis = GENERATE("1 2 3 1 2 7", "by_points");
  const GivenShapes given("surface = a\ncircumferential axis = " + axis + "\n", places);
  CHECK(given.diagnostics.all().empty());
  CHECK(given.shapes.name == "S");
  CHECK_FALSE(given.shapes.is_automatic);
  CHECK(given.of(0).kind == RoundShape::Kind::circumferential);
  CHECK(given.of(0).origin == Vector3d(1, 2, 3));
  CHECK((given.of(0).axis - Vector3d::UnitZ()).norm() < 1e-15);
  CHECK_FALSE(given.has(1));
  const GivenShapes down("surface = a\ncircumferential axis = by_direction\n", places);
  CHECK(down.of(0).origin == Vector3d(1, 2, 3));
  CHECK((down.of(0).axis + Vector3d::UnitZ()).norm() < 1e-15);
}

TEST_CASE("spheres have a centre, toruses a circle around an axis", "[contact][smoothing]") {
  const GivenShapes given(
      "surface = a\nspherical center = low\nsurface = B\ntoroidal axis = by_points radius = 4\n", places);
  CHECK(given.of(0).kind == RoundShape::Kind::spherical);
  CHECK(given.of(0).origin == Vector3d(1, 2, 3));
  CHECK(given.of(1).kind == RoundShape::Kind::toroidal);
  CHECK(given.of(1).arc_radius == 4.0);
  CHECK((given.of(1).axis - Vector3d::UnitZ()).norm() < 1e-15);
}

TEST_CASE("ALL stands for every surface, one region for all that it names", "[contact][smoothing]") {
  const GivenShapes all("surface = All\nspherical center = 0 0 1\n");
  CHECK(all.of(0).origin == Vector3d(0, 0, 1));
  CHECK(all.of(1).origin == Vector3d(0, 0, 1));
  const GivenShapes both("surface = b a\nspherical center = 0 0 2\n");
  CHECK(both.has(0));
  CHECK(both.has(1));
  const GivenShapes none("surface = other\nspherical center = 0 0 2\n");
  CHECK_FALSE(none.has(0));
  CHECK_FALSE(none.has(1));
}

TEST_CASE("of regions that name a surface the last one counts, by a region without a shape none",
          "[contact][smoothing]") {
  SurfaceSmoothing smoothing;
  for (const double z : {1.0, 2.0}) {
    SmoothingRegion region;
    region.surfaces = {DeckName{"a", {}}};
    region.shape = SphericalShape{Vector3d(0, 0, z)};
    smoothing.regions.push_back(region);
  }
  smoothing.regions.push_back({});
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1}).build();
  Diagnostics diagnostics;
  const SmoothingShapes shapes =
      shapes_of_deck(smoothing, make_model(mesh, "contact surface a contains block_1\n"), {}, diagnostics);
  REQUIRE(shapes.surfaces[{0}].given.size() == 1);
  CHECK(shapes.surfaces[{0}].given[0].origin.z() == 2.0);
}

TEST_CASE("axes through one point, and places that are nowhere, are errors", "[contact][smoothing]") {
  const auto told = [](const std::string& lines, const std::string& definitions) {
    const GivenShapes given(lines, definitions);
    CHECK_FALSE(given.has(0));
    return given.diagnostics.has_errors();
  };
  CHECK(told("surface = a\ncircumferential axis = 1 2 3 1 2 3\n", ""));
  CHECK(told("surface = a\ncircumferential axis = none\n", places));
  CHECK(told("surface = a\nspherical center = nowhere\n", places));
  CHECK(told("surface = a\ntoroidal axis = half radius = 1\n",
             "define axis half with point low direction down\ndefine direction down with vector 0 0 1\n"));
  // Points that are near each other, in whatever units, are not one.
  const GivenShapes small("surface = a\ncircumferential axis = 0 0 0 0 1e-200 0\n");
  CHECK((small.of(0).axis - Vector3d::UnitY()).norm() < 1e-12);
}

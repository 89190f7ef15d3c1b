// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/contact_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/loft_shape.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Element 1 a hexahedron; 2, 3 shells of block_2 that share an edge; 4, 5 a chain of beams; 6, 7 particles.
/// Every lofted block has its size as an attribute.
MeshBuilder every_kind() {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_shells({.id = 2, .cells = {2, 1}, .origin = {0, 0, 5}, .u = {2, 0, 0}});
  b.add_beams({.id = 3, .cells = 2, .from = {0, 7, 0}, .to = {2, 7, 0}});
  b.add_spheres(4, "", {{0, 9, 0}, {3, 9, 0}});
  b.set_attributes(2, {"thickness"}, {0.1, 0.1});
  b.set_attributes(3, {"area"}, {1.0, 1.0});
  b.set_attributes(4, {"radius"}, {0.25, 0.5});
  return b;
}

/// The surfaces of the lofted parts, by element id: "2 s 6 facets".
std::string list_owners(const Mesh& mesh, const ContactModel& model) {
  std::map<std::int64_t, std::string> owners;
  std::map<std::int64_t, int> parts;
  const auto add = [&](ElementIndex element, SurfaceIndex surface) {
    const std::int64_t id = mesh.element_id(element);
    const std::string& name = model.surfaces.surfaces[surface].name;
    if (owners.try_emplace(id, name).first->second != name) owners[id] = "two surfaces";
    ++parts[id];
  };
  REQUIRE(model.surface_of_facet.size() == model.loft.facets.size());
  REQUIRE(model.surface_of_sphere.size() == model.loft.spheres.size());
  for (std::size_t i = 0; i < model.loft.facets.size(); ++i)
    add(model.loft.facets[i].element, model.surface_of_facet[i]);
  for (std::size_t i = 0; i < model.loft.spheres.size(); ++i)
    add(model.loft.spheres[i].element, model.surface_of_sphere[i]);
  std::string text;
  for (const auto& [id, name] : owners) text += fmt::format("{} {} {}\n", id, name, parts[id]);
  return text;
}

}  // namespace

TEST_CASE("every part of a loft knows the surface that owns its element", "[contact][model]") {
  // Surfaces stand in another order than elements. Shells: top, bottom and 3 free edges each; beams: 6 sides
  // and 2 facets at the free end each.
  const Mesh mesh = every_kind().build();
  const auto model = make_model(mesh,
                                "contact surface dust contains block_4\n"
                                "begin contact surface picked\n element = 5 2\nend\n"
                                "contact surface rest contains block_1 block_2 block_3\n");
  REQUIRE(model.messages.empty());
  CHECK(list_owners(mesh, model) ==
        "2 picked 5\n"
        "3 rest 5\n"
        "4 rest 8\n"
        "5 picked 8\n"
        "6 dust 1\n"
        "7 dust 1\n");
  CHECK(list_faces(mesh, model.surfaces.surfaces[{2}]) == "1:1 1:2 1:3 1:4 1:5 1:6");
}

TEST_CASE("lofts of several surfaces close up together", "[contact][model]") {
  const Mesh mesh = every_kind().build();
  const auto model = make_model(mesh,
                                "begin contact surface left\n element = 2\nend\n"
                                "begin contact surface right\n element = 3\nend\n");
  REQUIRE(model.messages.empty());
  CHECK(is_closed(model.loft));
  CHECK(enclosed_volume(model.loft) == Approx(2 * 0.1).epsilon(1e-12));
}

TEST_CASE("elements that no surface owns are not lofted", "[contact][model]") {
  const Mesh mesh = every_kind().build();
  const auto one = make_model(mesh, "begin contact surface s\n element = 2\nend\n");
  CHECK(list_owners(mesh, one) == "2 s 6\n");  // without its neighbour all four edges are free
  const auto near = make_model(mesh,
                               "skin all blocks = on\n"
                               "restrict contact to subdomain defined by radius 1 and point 3 9 0\n");
  REQUIRE(near.messages.empty());
  CHECK(list_owners(mesh, near) == "7 block_4 1\n");
}

TEST_CASE("dead elements are not lofted, and their neighbours' edges are free", "[contact][model][death]") {
  const Mesh mesh = every_kind().build();
  const auto model = make_model(mesh, "skin all blocks = on\n", "", all_but(mesh, {3, 4, 6}));
  REQUIRE(model.messages.empty());
  CHECK(list_owners(mesh, model) ==
        "2 block_2 6\n"
        "5 block_3 10\n"
        "7 block_4 1\n");
}

TEST_CASE("a model of solids alone has no lofts and needs no sizes", "[contact][model]") {
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1}).build();
  const auto model = make_model(mesh, "skin all blocks = on\n");
  CHECK(model.messages.empty());
  CHECK(model.loft.vertices.cols() == 0);
  CHECK(model.surfaces.surfaces.at(0).faces.size() == 6);
}

TEST_CASE("the planes of the region are part of the model", "[contact][model]") {
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1}).build();
  const Region region = parse_region(
      "begin analytic object floor\n normal direction = 0 0 1\n origin = 0 0 -2\nend\n"
      "begin contact definition\n contact surface ground contains floor\nend\n");
  const auto model = make_model(mesh, region);
  REQUIRE(model.messages.empty());
  REQUIRE(model.planes.size() == 1);
  CHECK(model.planes[0].origin == Eigen::Vector3d(0, 0, -2));
  CHECK(model.surfaces.surfaces.at(0).analytic_planes == std::vector<std::uint32_t>{0});
}

TEST_CASE("names of the finite element model's aliases make surfaces", "[contact][model]") {
  const Mesh mesh = every_kind().build();
  const auto model = make_model(mesh, "contact surface s contains cube\n",
                                "begin finite element model m\n alias block_1 as cube\nend\n");
  CHECK(model.messages.empty());
  CHECK(model.surfaces.surfaces.at(0).faces.size() == 6);
}

TEST_CASE("all that is wrong with surfaces, sizes and references appears in one run", "[contact][model]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_shells({.id = 2, .origin = {0, 0, 5}});
  const Mesh mesh = b.build();
  const auto model = make_model(mesh,
                                "contact surface solid contains block_1 block_3\n"
                                "contact surface thin contains block_2\n"
                                "begin interaction\n side a = solid\n side b = thinn\nend\n");
  CHECK(model.messages ==
        "c.i:1:40: error: the mesh has no side set, block or assembly 'block_3'; did you mean 'block_1'?\n"
        "c.i:2:1: error: block 'block_2' (SHELL4) has no thickness to loft it with: neither a section nor an "
        "attribute on the mesh; it is in contact through surface 'thin'\n"
        "c.i:5:11: error: there is no contact surface 'thinn'; did you mean 'thin'?\n");
}

TEST_CASE("a check of names reports names alone", "[contact][model]") {
  const Mesh mesh = MeshBuilder().add_shells({.id = 1}).build();
  Region region;
  region.contact = parse_contact(
      "contact surface a contains lid\n"
      "contact surface b contains block_9\n");
  const SimulationDefinition definition =
      parse_definitions("begin finite element model m\n alias block_1 as lid\nend\n");
  Diagnostics diagnostics;
  find_name_errors(definition, region, mesh, diagnostics);
  REQUIRE(diagnostics.all().size() == 1);
  CHECK(diagnostics.all()[0].text == "the mesh has no side set, block or assembly 'block_9'");
}

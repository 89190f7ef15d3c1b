// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_tracker.hpp"

#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/random_contact.hpp"
#include "support/slow_surfaces.hpp"

// Ownership that follows deaths is compared with what a slow resolution of the living elements gives.

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Surfaces of a mesh whose elements die.
class DyingMesh {
 public:
  DyingMesh(const Mesh& of_mesh, const std::string& contact_lines)
      : mesh(of_mesh),
        lines(contact_lines),
        contact(parse_contact(contact_lines)),
        surfaces(resolve(mesh, lines)),
        alive(mesh.n_elements(), 1),
        elements(mesh),
        faces(mesh, elements),
        living(make_rules(), faces) {}
  DyingMesh(const DyingMesh&) = delete;
  DyingMesh& operator=(const DyingMesh&) = delete;

  std::vector<SurfaceChange> kill(const std::vector<ElementIndex>& dead) {
    for (const ElementIndex element : dead) alive[element.value] = 0;
    return living.update_for_deaths(dead, surfaces);
  }
  std::string all() const { return describe_all(mesh, surfaces); }
  std::string all_anew() const { return describe_all(mesh, resolve_slowly(contact, mesh, alive)); }

  const Mesh& mesh;
  std::string lines;
  ContactDefinition contact;
  Resolved surfaces;
  std::vector<std::uint8_t> alive;
  NodeElements elements;
  FaceGroups faces;
  SurfaceTracker living;

 private:
  OwnershipRules make_rules() const {
    Diagnostics diagnostics;
    return {make_surface_requests(contact, {}, mesh, diagnostics), mesh, contact.subdomain};
  }
};

std::vector<ElementIndex> some_of_the_living(const std::vector<std::uint8_t>& alive, Random& random) {
  const std::uint32_t share = 1 + random() % 12;
  std::vector<ElementIndex> dead;
  for (std::uint32_t i = 0; i < alive.size(); ++i) {
    if (alive[i] != 0 && random() % share == 0) dead.push_back({i});
  }
  return dead;
}

}  // namespace

TEST_CASE("after any deaths ownership is what it would be without the dead", "[contact][death]") {
  int n_deaths = 0;
  for (unsigned seed = 0; seed < 150; ++seed) {
    Random random(seed);
    const Mesh mesh = random_mesh_of_all_kinds(random);
    DyingMesh dying(mesh, random_commands(mesh, random));
    INFO("seed " << seed << "\n" << dying.lines);
    REQUIRE(dying.surfaces.messages.empty());
    REQUIRE(dying.all() == dying.all_anew());
    for (int round = 0; round < 8; ++round) {
      const auto dead = some_of_the_living(dying.alive, random);
      dying.kill(dead);
      n_deaths += static_cast<int>(dead.size());
      REQUIRE(dying.all() == dying.all_anew());
    }
  }
  CHECK(n_deaths > 5000);
}

TEST_CASE("elements die one by one until none is left", "[contact][death]") {
  Random random(7);
  const Mesh mesh = random_mesh(random).build();
  DyingMesh dying(mesh,
                  "contact surface inner contains surface_1\nskin all blocks = on\n"
                  "contact surface late contains surface_2\n");
  std::vector<ElementIndex> order;
  for (std::uint32_t i = 0; i < mesh.n_elements(); ++i) order.push_back({i});
  std::shuffle(order.begin(), order.end(), random);
  for (const ElementIndex element : order) {
    dying.kill({element});
    REQUIRE(dying.all() == dying.all_anew());
  }
  for (const ContactSurface& surface : dying.surfaces.surfaces) CHECK(surface.is_empty());
}

TEST_CASE("changes are counted by surface", "[contact][death]") {
  // 3 x 3 x 3 cells; surface_1 is the top. The middle of the top, element 23, shows 5 faces and loses one.
  MeshBuilder builder;
  builder.add_hexes({.id = 1, .cells = {3, 3, 3}, .size = {3, 3, 3}});
  builder.add_side_set(1, "", [](const CandidateSide& c) { return c.centroid.z() > 2.9; });
  const Mesh mesh = builder.build();
  DyingMesh dying(mesh, "contact surface top contains surface_1\ncontact surface rest contains block_1\n");
  const auto changes = dying.kill({{22}});
  CHECK(changes[0].faces_lost == 1);
  CHECK(changes[0].faces_gained == 0);
  CHECK(changes[1].faces_lost == 0);
  CHECK(changes[1].faces_gained == 5);
  CHECK(changes[1].is_any());
  CHECK(dying.surfaces["top"].faces.size() == 8);
  CHECK(dying.surfaces["rest"].faces.size() == 50);
}

// SPDX-License-Identifier: BSD-3-Clause
#include <set>

#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/random_contact.hpp"
#include "support/slow_surfaces.hpp"

// What must hold for every mesh and every deck, tried on random ones.

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("random decks give what a slow resolution gives, no face twice", "[contact][properties]") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const Mesh mesh = random_mesh_of_all_kinds(random);
    const std::string lines = random_commands(mesh, random);
    INFO("seed " << seed << "\n" << lines);
    const auto result = resolve(mesh, lines);
    REQUIRE(result.messages.empty());
    const std::vector<std::uint8_t> alive(mesh.n_elements(), 1);
    REQUIRE(describe_all(mesh, result) ==
            describe_all(mesh, resolve_slowly(parse_contact(lines), mesh, alive)));
    std::set<ElementSide> faces;
    std::set<ElementIndex> lofted;
    for (const ContactSurface& surface : result.surfaces) {
      for (const ElementSide face : surface.faces) CHECK(faces.insert(face).second);
      for (const ElementIndex element : surface.lofted_elements) CHECK(lofted.insert(element).second);
    }
  }
}

TEST_CASE("a surface claims what it would own alone, and loses the rest to earlier ones",
          "[contact][properties]") {
  Random random(2);
  for (int round = 0; round < 30; ++round) {
    const Mesh mesh = random_mesh_or_blocking(random).build();
    const auto lines = random_lines(random);
    const auto result = resolve(mesh, join(lines));
    for (const SurfaceIndex i : indices(result.surfaces)) {
      const ContactSurface& surface = result.surfaces[i];
      std::size_t lost_faces = 0, lost_lofted = 0, lost_nodes = 0;
      for (const LostClaims& lost : surface.lost_to) {
        CHECK(lost.winner < i);
        lost_faces += lost.faces;
        lost_lofted += lost.lofted;
        lost_nodes += lost.nodes;
      }
      std::vector<std::string> first = lines;
      std::rotate(first.begin(), first.begin() + i.value, first.begin() + i.value + 1);
      const ContactSurface alone = resolve(mesh, join(first)).surfaces.front();
      CHECK(alone.lost_to.empty());
      CHECK(alone.faces.size() == surface.faces.size() + lost_faces);
      CHECK(alone.lofted_elements.size() == surface.lofted_elements.size() + lost_lofted);
      CHECK(alone.nodes.size() == surface.nodes.size() + lost_nodes);
    }
  }
}

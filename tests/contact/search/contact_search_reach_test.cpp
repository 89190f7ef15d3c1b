// SPDX-License-Identifier: BSD-3-Clause
// How far a search looks: margins by the size of faces, reaches of pairs, what deaths have exposed.
#include <cmath>
#include <functional>

#include "contact/search/contact_search.hpp"
#include "support/catch.hpp"
#include "support/contact_death.hpp"
#include "support/contact_faces.hpp"
#include "support/pair_sets.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// The widest gap, to 0.001, over which a search that `change` has made ready finds unit cubes.
double widest_gap(const std::string& lines, const std::function<void(ContactSearch&)>& change = {}) {
  double near = 0.0, far = 4.0;
  while (far - near > 1e-3) {
    const double gap = 0.5 * (near + far);
    ContactParts parts(stacked_cubes(gap), general_contact(lines));
    ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {});
    if (change) change(search);
    parts.find_candidates(search);
    const bool is_found = !parts.face_partners.partners.empty() || !parts.node_faces.partners.empty();
    (is_found ? near : far) = gap;
  }
  return near;
}

Approx about(double gap) { return Approx(gap).margin(2e-3); }

/// Of 0.15 times the root of a unit face on either side; of a corner with its quarter of three of them.
const double of_faces = 0.3, of_nodes = 0.15 + 0.15 * std::sqrt(0.75);

}  // namespace

TEST_CASE("the margin of a node goes by the smallest face at it, or its own area",
          "[contact][contact_search]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 1, 1}, .size = {2, 1, 1}});
  b.add_hexes({.id = 2, .origin = {0, 0, 5}, .size = {0.1, 2, 3}, .share_nodes = false});
  const ContactParts parts(b, general_contact());
  DashOptions wider;
  wider.search_length_scaling = 0.3;
  const ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {}),
      wide(parts.contact_mesh, parts.mesh, parts.rules, {}, wider);
  for (const ContactNodeIndex node : parts.contact_mesh.nodes()) {
    const Vector3d x = parts.kinematics.x(node);
    const bool is_small = x.z() > 4.0, is_middle = x.x() == 1.0;
    // Faces of 0.1 x 2, 0.1 x 3, 2 x 3; corners of unit cells have a quarter of three, the others of four.
    const double smallest = is_small ? 0.2 : is_middle ? 1.0 : 0.75;
    CHECK(search.margin_of(node) == Approx(0.15 * std::sqrt(smallest)));
    CHECK(wide.margin_of(node) == Approx(0.3 * std::sqrt(smallest)));
  }
}

TEST_CASE("a search finds what is within both margins and what its pair reaches for",
          "[contact][contact_search]") {
  CHECK(widest_gap("") == about(of_faces));
  CHECK(widest_gap(node_face) == about(of_nodes));
  CHECK(widest_gap("normal tolerance = 0.4\n") == about(of_faces + 0.4));
  CHECK(widest_gap("tracking distance = 0.5\n" + node_face) == about(of_nodes + 0.5));
  CHECK(widest_gap("contact offset = 0.2\n") == about(of_faces + 0.2));
}

TEST_CASE("as far as what is held at the start a search reaches at the start only",
          "[contact][contact_search]") {
  const std::string holds = "capture tolerance = 0.6\n";
  const auto do_not = [](ContactSearch& search) {
    CHECK(search.has_start_reach());
    search.reach_for_start(false);
    CHECK(search.has_start_reach());
  };
  CHECK(widest_gap(holds) == about(of_faces + 0.6));
  CHECK(widest_gap(holds, do_not) == about(of_faces));
  CHECK(widest_gap(holds, [](ContactSearch& search) {
          search.reach_for_start(false);
          search.reach_for_start(true);
        }) == about(of_faces + 0.6));
  widest_gap("normal tolerance = 0.1\n", [](ContactSearch& search) { CHECK(!search.has_start_reach()); });
}

TEST_CASE("a search reaches at least as far as it is told to", "[contact][contact_search]") {
  const auto reach = [](ContactSearch& search) {
    search.reach_at_least(IndexedVector<PairIndex, double>{0.8});
  };
  CHECK(widest_gap("", reach) == about(of_faces + 0.8));
  CHECK(widest_gap("normal tolerance = 1.1\n", reach) == about(of_faces + 1.1));
}

TEST_CASE("what a death exposes meets what it may where all else keeps its first partners",
          "[contact][contact_search]") {
  // Two cells high, the upper ones of which die one by one; a cube that stood on none of them is over both.
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {4, 1, 2}, .size = {4, 1, 2}});
  b.add_hexes({.id = 2, .origin = {1.1, 0.1, 8.0}, .size = {0.8, 0.8, 0.8}, .share_nodes = false});
  const std::string lines = general_contact("interaction behavior = infinitesimal_sliding\n");
  ContactParts parts(b, lines);
  ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {});
  parts.find_candidates(search);
  REQUIRE(parts.face_partners.partners.empty());
  const auto put = [&](double x, double height) {
    const Vector3d way = Vector3d(x, 0.1, height) - parts.x.col(30);
    for (const NodeIndex node : parts.mesh.blocks()[1].nodes) parts.x.col(node.value) += way;
    parts.move();
    parts.find_candidates(search);
    const std::uint32_t bottom = face_of(parts, 8, -Vector3d::UnitZ()).value;
    std::set<std::uint32_t> elements;
    for (const auto& [first, second] : in_set(parts.face_partners)) {
      if (second == bottom && parts.kinematics.area(parts.contact_mesh.faces[{first}]).z() > 0.9)
        elements.insert(parts.contact_mesh.faces[{first}].side.element().value);
    }
    return elements;
  };
  using Elements = std::set<std::uint32_t>;
  REQUIRE(parts.x.col(30) == Vector3d(1.1, 0.1, 8.0));
  CHECK(put(1.1, 2.0) == Elements{});  // elements 4 to 7 are the upper ones
  search.remap(let_die(parts, lines, {6}));
  CHECK(put(1.1, 1.0) == Elements{1});
  search.remap(let_die(parts, lines, {6, 8}));
  CHECK(put(1.1, 1.0) == Elements{1});  // as new as before
  CHECK(put(3.1, 1.0) == Elements{3});
  CHECK(put(2.1, 2.0) == Elements{});
}

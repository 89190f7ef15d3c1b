// SPDX-License-Identifier: BSD-3-Clause
#include "contact/output/side_set_totals.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/watched_contact.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// A plate of 4 x 4 cells and a cube of 2 x 2 on its middle. Side sets: the cube's whole skin, its bottom, a
/// half and a quarter of that, its sides, its top.
MeshBuilder cube_with_side_sets() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {4, 4, 1}, .size = {4, 4, 1}});
  b.add_hexes({.id = 2, .cells = {2, 2, 1}, .origin = {1, 1, 1}, .size = {2, 2, 1}, .share_nodes = false});
  const auto is_outside = [](const CandidateSide& side) {
    return side.block_id == 2 && std::abs((side.centroid - Vector3d(2, 2, 1.5)).dot(side.normal)) > 0.4 &&
           ((side.centroid + 0.01 * side.normal - Vector3d(2, 2, 1.5)).cwiseQuotient(Vector3d(1, 1, 0.5)))
                   .lpNorm<Eigen::Infinity>() > 1.0;
  };
  const auto is_bottom = [=](const CandidateSide& side) {
    return is_outside(side) && side.normal.z() < -0.5;
  };
  b.add_side_set(1, "skin", is_outside);
  b.add_side_set(2, "bottom", is_bottom);
  b.add_side_set(3, "half",
                 [=](const CandidateSide& side) { return is_bottom(side) && side.centroid.x() < 2.0; });
  b.add_side_set(4, "", [=](const CandidateSide& side) {
    return is_bottom(side) && side.centroid.x() < 2.0 && side.centroid.y() < 2.0;
  });
  b.add_side_set(6, "other",
                 [=](const CandidateSide& side) { return is_bottom(side) && side.centroid.x() > 2.0; });
  b.add_side_set(5, "sides", [=](const CandidateSide& side) {
    return is_outside(side) && std::abs(side.normal.z()) < 0.5;
  });
  return b;
}

std::string lines(const std::string& more) {
  return general_contact("penalty stiffness = 1000\n" + more,
                         "contact surface low contains block_1\ncontact surface high contains block_2\n");
}

const std::string friction =
    "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 0.5\n";

}  // namespace

TEST_CASE("a side set of the whole surface has the totals of the surface", "[contact][side_set_totals]") {
  const bool by_nodes = GENERATE(false, true), is_tied = GENERATE(false, true);
  const std::string formulation = by_nodes ? "constraint formulation = node_face\n" : "";
  WatchedContact bodies(cube_with_side_sets(),
                        lines(formulation + (is_tied ? "friction model = tied\n" : friction)));
  bodies.ask();
  bodies.shift(1, {0.013, 0.004, -0.01});
  bodies.ask();
  bodies.take(1);
  REQUIRE(bodies.global("contact_force_high").z() > 30.0);
  for (const ContactTotalRow& row : contact_total_rows()) {
    if (row.is_of_pairs) continue;
    const std::string name(row.name);
    const Vector3d whole = bodies.global(name + "_high");
    for (const char* set : {"_skin", "_bottom", "_surface_2"}) {
      INFO(name << set);
      CHECK((bodies.global(name + set) - whole).norm() < 1e-9);
    }
  }
  CHECK(bodies.global("contact_force_sides").norm() < 1e-9);
}

TEST_CASE("parts of a surface get their parts of its contact", "[contact][side_set_totals]") {
  WatchedContact bodies(cube_with_side_sets(), lines(""));
  bodies.shift(1, {0, 0, -0.01});
  bodies.ask();
  bodies.take(1);
  CHECK(bodies.global("contact_force_high").z() == Approx(40.0));
  CHECK(bodies.global("contact_force_half").z() == Approx(20.0));
  CHECK(bodies.global("contact_force_surface_4").z() == Approx(10.0));
  CHECK(bodies.global("contact_area_surface_4").x() == Approx(1.0));
  // About the origin, of a force at x = 1.5, y = 2.
  CHECK((bodies.global("contact_moment_half") - Vector3d(40, -30, 0)).norm() < 1e-9);
}

TEST_CASE("two halves of a surface add up to it where nodes meet faces", "[contact][side_set_totals]") {
  WatchedContact bodies(cube_with_side_sets(), lines("constraint formulation = node_face\n" + friction));
  bodies.shift(1, {0.1, 0.2, -0.01});
  bodies.ask();
  bodies.take(1);
  for (const char* name : {"contact_force_", "contact_moment_", "contact_area_"}) {
    const Vector3d half = bodies.global(std::string(name) + "half"),
                   other = bodies.global(std::string(name) + "other");
    CHECK(half.norm() > 0.1);
    CHECK((half + other - bodies.global(std::string(name) + "high")).norm() < 1e-9);
  }
}

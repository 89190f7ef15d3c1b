// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/initial_gaps.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace initial_gaps_test {

namespace {

/// Two cubes, the second one above the first.
MeshBuilder two_cubes(double gap) {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_hexes({.id = 2, .origin = {0.25, 0.25, 1.0 + gap}, .share_nodes = false});
  return b;
}

InitialGap start_of(double gap, const std::string& lines = "") {
  const Mesh mesh = two_cubes(gap).build();
  const auto model = make_model(mesh, general_contact(lines));
  REQUIRE(model.messages.empty());
  const auto starts = find_initial_gaps(model, mesh, {});
  REQUIRE(starts.size() == 1);
  return starts[{0}];
}

}  // namespace

TEST_CASE("the smallest gap of a pair is that of its nearest faces", "[contact][initial_gaps]") {
  CHECK(start_of(0.05).smallest_gap == Approx(0.05));
  CHECK(start_of(-0.05).smallest_gap == Approx(-0.05));
  CHECK(start_of(0.0).smallest_gap == Approx(0.0).margin(1e-15));
  CHECK(start_of(0.05).n_in_reach >= 1);
}

TEST_CASE("the smallest gap of nodes and faces is that of nodes over faces", "[contact][initial_gaps]") {
  const std::string lines = "constraint formulation = node_face\n";
  CHECK(start_of(0.05, lines).smallest_gap == Approx(0.05));
  CHECK(start_of(-0.05, lines).smallest_gap == Approx(-0.05));
}

TEST_CASE("of a pair out of reach no gap is known", "[contact][initial_gaps]") {
  const InitialGap far = start_of(2.0);
  CHECK(std::isnan(far.smallest_gap));
  CHECK(far.n_in_reach == 0);
}

TEST_CASE("gaps to a plane are those of all nodes", "[contact][initial_gaps]") {
  const Mesh mesh = two_cubes(0.05).build();
  const Region region = parse_region(
      "begin analytic object ground\n normal direction = 0 0 -2\n origin = 0 0 2.5\nend\n"
      "begin contact definition\n contact surface ceiling contains ground\n skin all blocks = on\n"
      " begin interaction defaults\n  general contact = on\n end\nend\n");
  const auto model = make_model(mesh, region);
  REQUIRE(model.messages.empty());
  const auto starts = find_initial_gaps(model, mesh, {});
  REQUIRE(starts.size() == 3);
  CHECK(starts[{0}].smallest_gap == Approx(1.5));
  CHECK(starts[{0}].n_in_reach == 8);
  CHECK(starts[{1}].smallest_gap == Approx(2.5 - 2.05));
  CHECK(starts[{2}].smallest_gap == Approx(0.05));
}

}  // namespace initial_gaps_test

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/mean_edge.hpp"

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using test::ContactParts;
using test::MeshBuilder;

namespace {

/// A cube of edge 2, block_1, and one of edge 1 above it, block_2.
MeshBuilder large_and_small() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .size = {2, 2, 2}});
  return b.add_hexes({.id = 2, .origin = {0, 0, 2.5}, .share_nodes = false});
}

std::string interaction(const std::string& lines) {
  return "skin all blocks = on\nbegin interaction\n" + lines + "end\n";
}

double mean_edge_of(const ContactParts& parts) {
  return mean_edge(parts.kinematics, parts.model.pairs[PairIndex{0}]);
}

}  // namespace

TEST_CASE("edges of both sides count, with sides those of SIDE A", "[contact][mean_edge]") {
  const ContactParts both(large_and_small(), interaction("surfaces = block_1 block_2\n"));
  CHECK(mean_edge_of(both) == Approx(1.5));
  const ContactParts large(large_and_small(), interaction("side a = block_1\nside b = block_2\n"));
  CHECK(mean_edge_of(large) == Approx(2.0));
  const ContactParts small(large_and_small(), interaction("side a = block_2\nside b = block_1\n"));
  CHECK(mean_edge_of(small) == Approx(1.0));
}

TEST_CASE("AUTO of SEARCH DISTANCE is two mean edges, a number is itself", "[contact][mean_edge]") {
  const auto distance = [](const std::string& word) {
    const ContactParts parts(large_and_small(),
                             interaction("surfaces = block_1 block_2\nsearch distance = " + word + "\n"));
    return find_search_distance(parts.kinematics, parts.model.pairs[PairIndex{0}]);
  };
  CHECK(distance("auto") == Approx(3.0));
  CHECK(distance("0.7") == Approx(0.7));
}

TEST_CASE("rods without faces count by their lengths", "[contact][mean_edge]") {
  MeshBuilder b;
  b.add_beams({.id = 1, .cells = 2, .from = {-2, 0, 0}, .to = {2, 0, 0}});
  b.add_beams({.id = 2, .cells = 2, .from = {0, -3, 1}, .to = {0, 3, 1}});
  for (const std::int64_t id : {1, 2}) b.set_attributes(id, {"area"}, {0.01, 0.01});
  const ContactParts rods(b, interaction("surfaces = block_1 block_2\n"));
  CHECK(mean_edge_of(rods) == Approx(2.5));
}

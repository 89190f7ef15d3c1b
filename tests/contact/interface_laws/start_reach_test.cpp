// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/start_reach.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

constexpr PairIndex limited{0}, free_pair{1};
constexpr SurfaceIndex low{0}, high{1};

/// A pair of two surfaces with a SEARCH DISTANCE, and one without.
SurfacePairs two_pairs(OptionalIndex<SurfaceIndex> side_b = {}) {
  SurfacePairs pairs(2);
  pairs[limited].first = low;
  pairs[limited].second = high;
  pairs[limited].search_distance.emplace();
  pairs[limited].side_b = side_b;
  return pairs;
}

}  // namespace

TEST_CASE("nothing is left out without a SEARCH DISTANCE, or before it is set", "[contact][start_reach]") {
  CHECK_FALSE(StartReach(SurfacePairs(1)).exists());
  StartReach reach(two_pairs());
  CHECK(reach.exists());
  CHECK(reach.distance(limited) == 0.0);
  CHECK(reach.may_meet_faces(limited, {3}, {4}, low));
  reach.set_distance(limited, 0.5);
  CHECK(reach.distance(limited) == 0.5);
  CHECK_FALSE(reach.may_meet_faces(limited, {3}, {4}, low));
  CHECK_FALSE(reach.may_meet_plane(limited, {2}));
  CHECK(reach.may_meet_faces(free_pair, {3}, {4}, low));
}

TEST_CASE("one side that was near is enough", "[contact][start_reach]") {
  StartReach reach(two_pairs());
  reach.set_distance(limited, 0.5);
  reach.mark_face(limited, {4});
  reach.mark_edge(limited, {1});
  CHECK(reach.may_meet_faces(limited, {3}, {4}, low));
  CHECK(reach.may_meet_faces(limited, {4}, {5}, low));
  CHECK_FALSE(reach.may_meet_faces(limited, {3}, {5}, low));
  CHECK(reach.may_meet_node(limited, {9}, {4}, high));
  CHECK_FALSE(reach.may_meet_node(limited, {4}, {9}, high));
  CHECK(reach.may_meet_edges(limited, {0}, {1}, low));
  CHECK_FALSE(reach.may_meet_edges(limited, {4}, {5}, low));
  CHECK(reach.has_any(limited));
  CHECK_FALSE(reach.has_any(free_pair));
}

TEST_CASE("with sides that of SIDE B counts", "[contact][start_reach]") {
  StartReach reach(two_pairs(high));
  reach.set_distance(limited, 0.5);
  reach.mark_face(limited, {4});
  reach.mark_node(limited, {6});
  CHECK(reach.may_meet_faces(limited, {3}, {4}, low));
  CHECK(reach.may_meet_faces(limited, {4}, {3}, high));
  CHECK_FALSE(reach.may_meet_faces(limited, {4}, {3}, low));
  CHECK(reach.may_meet_node(limited, {6}, {0}, high));
  CHECK_FALSE(reach.may_meet_node(limited, {6}, {0}, low));
  CHECK(reach.may_meet_node(limited, {0}, {4}, low));
  CHECK(reach.may_meet_plane(limited, {6}));
}

TEST_CASE("what deaths expose is looked at, what was near stays so", "[contact][start_reach]") {
  StartReach reach(two_pairs());
  reach.set_distance(limited, 0.5);
  reach.mark_face(limited, {2});
  ContactRemap remap;
  remap.faces.resize(3);  // the first has died, the others move up before a new one
  remap.faces[{1}] = FaceIndex{0};
  remap.faces[{2}] = FaceIndex{1};
  remap.n_faces_after = 3;
  reach.remap(remap);
  CHECK(reach.may_meet_faces(limited, {0}, {1}, low));
  CHECK(reach.may_meet_faces(limited, {0}, {2}, low));
  CHECK_FALSE(reach.may_meet_faces(limited, {0}, {0}, low));
}

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_edits.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

using Faces = std::vector<ElementSide>;

ElementSide face(std::uint32_t element) { return {{element}, 1}; }

Claim owned_by(std::uint32_t surface) { return {SurfaceIndex{surface}, {}}; }

}  // namespace

TEST_CASE("what surfaces gain and lose keeps their lists ascending", "[contact][ownership]") {
  ContactSurfaces surfaces;
  surfaces.surfaces.resize(2);
  surfaces.surfaces[{0}].faces = {face(1), face(3), face(5)};
  SurfaceEdits edits(2);
  edits.change_face(face(5), owned_by(0), owned_by(1));
  edits.change_face(face(1), owned_by(0), {});
  edits.change_face(face(4), {}, owned_by(0));
  edits.change_face(face(2), {}, owned_by(0));
  edits.change_face(face(3), owned_by(0), owned_by(0));
  edits.change_node({7}, {}, owned_by(1));
  const auto changes = edits.apply(surfaces);
  CHECK(surfaces.surfaces[{0}].faces == Faces{face(2), face(3), face(4)});
  CHECK(surfaces.surfaces[{1}].faces == Faces{face(5)});
  CHECK(surfaces.surfaces[{1}].nodes == std::vector<NodeIndex>{{7}});
  CHECK(changes[{0}].faces_gained == 2);
  CHECK(changes[{0}].faces_lost == 2);
  CHECK(changes[{1}].faces_gained == 1);
  CHECK(changes[{1}].nodes_gained == 1);
}

TEST_CASE("lost claims are counted by loser and winner, and go when none is left", "[contact][ownership]") {
  ContactSurfaces surfaces;
  surfaces.surfaces.resize(3);
  SurfaceEdits edits(3);
  const SurfaceIndex first{0}, second{1}, loser{2};
  const Claim lost_to_second{second, {{loser, second}}}, lost_to_first{first, {{loser, first}}};
  edits.change_face(face(0), {}, lost_to_second);
  edits.change_face(face(1), {}, lost_to_first);
  edits.change_lofted({2}, {}, lost_to_second);
  edits.apply(surfaces);
  const auto& lost_to = surfaces.surfaces[{2}].lost_to;
  REQUIRE(lost_to.size() == 2);
  CHECK(lost_to[0].winner == SurfaceIndex{0});
  CHECK(lost_to[0].faces == 1);
  CHECK(lost_to[1].winner == SurfaceIndex{1});
  CHECK(lost_to[1].faces == 1);
  CHECK(lost_to[1].lofted == 1);
  SurfaceEdits later(3);
  later.change_face(face(1), lost_to_first, {});
  later.change_face(face(0), lost_to_second, {});
  later.apply(surfaces);
  REQUIRE(lost_to.size() == 1);
  CHECK(lost_to[0].winner == SurfaceIndex{1});
  CHECK(lost_to[0].faces == 0);
  CHECK(lost_to[0].lofted == 1);
}

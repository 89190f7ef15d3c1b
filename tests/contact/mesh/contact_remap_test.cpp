// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/contact_remap.hpp"

#include "contact/mesh/contact_mesh.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

const std::string all_skins = "skin all blocks = on\nbegin interaction defaults\ngeneral contact = on\nend\n";

/// The contact mesh before and after elements die.
struct RemappedMesh {
  Mesh mesh;
  ContactMesh before, after;
  ContactRemap remap;

  RemappedMesh(const MeshBuilder& b, const std::vector<std::int64_t>& dead)
      : mesh(b.build()),
        before(make_contact_mesh(make_model(mesh, all_skins), mesh)),
        after(make_contact_mesh(make_model(mesh, all_skins, "", all_but(mesh, dead)), mesh)),
        remap(make_contact_remap(before, after)) {}
};

/// What of the old is found at its new position is the same, and what is gone is nowhere in the new.
void check_positions(const RemappedMesh& of) {
  const ContactMesh &before = of.before, &after = of.after;
  const ContactRemap& remap = of.remap;
  REQUIRE(remap.faces.size() == before.faces.size());
  REQUIRE(remap.rows.size() == before.surface_nodes.size());
  REQUIRE(remap.nodes.size() == before.n_nodes());
  REQUIRE(remap.edges.size() == before.edges.size());
  CHECK(remap.n_faces_after == after.faces.size());
  CHECK(remap.n_rows_after == after.surface_nodes.size());
  CHECK(remap.n_nodes_after == after.n_nodes());
  CHECK(remap.n_edges_after == after.edges.size());
  for (const FaceIndex i : indices(before.faces)) {
    const ContactFace& old = before.faces[i];
    const auto is_same = [&](const ContactFace& face) {
      return face.side == old.side && face.surface == old.surface;
    };
    CHECK(remap.faces[i].has_value() == std::ranges::any_of(after.faces, is_same));
    if (!remap.faces[i]) continue;
    const ContactFace& now = after.faces[*remap.faces[i]];
    CHECK(is_same(now));
    for (std::size_t k = 0; k < 4; ++k) CHECK(*remap.nodes[old.corners[k]] == now.corners[k]);
  }
  for (const SurfaceNodeIndex i : indices(before.surface_nodes)) {
    if (!remap.rows[i]) continue;
    const SurfaceNode &old = before.surface_nodes[i], &now = after.surface_nodes[*remap.rows[i]];
    CHECK(now.surface == old.surface);
    CHECK(after.mesh_nodes[now.node] == before.mesh_nodes[old.node]);
    CHECK(now.radius == old.radius);
  }
  for (const EdgeIndex i : indices(before.edges)) {
    if (!remap.edges[i]) continue;
    for (const std::size_t end : {0, 1})
      CHECK(after.mesh_nodes[after.edges[*remap.edges[i]].nodes[end]] ==
            before.mesh_nodes[before.edges[i].nodes[end]]);
  }
}

}  // namespace

TEST_CASE("where nothing dies everything stays where it is", "[contact][contact_remap]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 1}});
  add_plate(b, {.id = 2, .origin = {0, 0, 3}, .share_nodes = false}, 0.2);
  add_rod(b, {.id = 3, .cells = 2, .from = {5, 0, 0}, .to = {6, 0, 0}});
  const RemappedMesh same(b, {});
  check_positions(same);
  for (const FaceIndex i : indices(same.before.faces)) CHECK(same.remap.faces[i] == i);
  for (const SurfaceNodeIndex i : indices(same.before.surface_nodes)) CHECK(same.remap.rows[i] == i);
  for (const ContactNodeIndex i : same.before.nodes()) CHECK(same.remap.nodes[i] == i);
  for (const EdgeIndex i : indices(same.before.edges)) CHECK(same.remap.edges[i] == i);
}

TEST_CASE("faces and nodes of what lives are found behind any death", "[contact][contact_remap]") {
  const std::int64_t dead = GENERATE(1, 2, 3, 5, 8);
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}});
  b.add_hexes({.id = 2, .origin = {0, 0, 3}, .share_nodes = false});
  const RemappedMesh one(b, {dead});
  check_positions(one);
  std::size_t n_gone = 0;
  for (const auto& position : one.remap.faces) n_gone += position ? 0 : 1;
  CHECK(n_gone == 3);  // a corner of the block; what it exposes is new
  CHECK(one.after.faces.size() == one.before.faces.size());
}

TEST_CASE("lofts, rods and balls that live are found behind deaths", "[contact][contact_remap]") {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {3, 1}, .u = {3, 0, 0}}, 0.2);
  add_rod(b, {.id = 2, .cells = 3, .from = {0, 5, 0}, .to = {3, 5, 0}});
  add_balls(b, 3, {{0, 9, 0}, {1, 9, 0}}, 0.3);
  // The first shell, the middle of the rod, the first ball: elements 1, 5 and 7.
  const RemappedMesh some(b, {1, 5, 7});
  check_positions(some);
  std::size_t n_edges = 0, n_rows = 0;
  for (const auto& position : some.remap.edges) n_edges += position ? 1 : 0;
  for (const auto& position : some.remap.rows) n_rows += position ? 1 : 0;
  CHECK(n_edges == some.after.edges.size());
  CHECK(n_rows == some.after.surface_nodes.size());
}

TEST_CASE("values go along with what they are of", "[contact][contact_remap]") {
  NewPositions<FaceIndex> positions{FaceIndex{2}, std::nullopt, FaceIndex{0}};
  std::vector<int> values{10, 20, 30}, unused;
  transfer(positions, 4, -1, values);
  CHECK(values == std::vector{30, -1, 10, -1});
  transfer(positions, 4, -1, unused);
  CHECK(unused.empty());
  CHECK(*number_after(positions, 0) == 2);
  CHECK_FALSE(number_after(positions, 1));
}

TEST_CASE("lists keep the rows and partners that are left, and say which pairs these were",
          "[contact][contact_remap]") {
  const auto lists = list_by_row<FaceIndex, FaceIndex>(3, [](const auto& take) {
    take(FaceIndex{0}, FaceIndex{1});
    take(FaceIndex{0}, FaceIndex{2});
    take(FaceIndex{1}, FaceIndex{2});
    take(FaceIndex{2}, FaceIndex{3});
  });
  const NewPositions<FaceIndex> rows{FaceIndex{1}, std::nullopt, FaceIndex{0}};
  const NewPositions<FaceIndex> partners{std::nullopt, std::nullopt, FaceIndex{1}, FaceIndex{2}};
  std::vector<std::size_t> before;
  const auto after = transferred(lists, rows, partners, 2, before);
  CHECK(after.n_rows() == 2);
  CHECK(std::vector<std::size_t>{3, 1} == before);
  REQUIRE(after.of(FaceIndex{0}).size() == 1);
  CHECK(after.of(FaceIndex{0})[0] == FaceIndex{2});
  REQUIRE(after.of(FaceIndex{1}).size() == 1);
  CHECK(after.of(FaceIndex{1})[0] == FaceIndex{1});
}

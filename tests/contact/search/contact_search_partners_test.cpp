// SPDX-License-Identifier: BSD-3-Clause
// What may meet what: by surfaces, formulations, elements, bodies and kinds of edges.
#include "contact/mesh/feature_edges.hpp"
#include "contact/search/contact_search.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/lofted_meshes.hpp"
#include "support/pair_sets.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// Pairs of edges that a search finds, by the blocks of both.
std::set<std::pair<std::size_t, std::size_t>> blocks_of_edges(const MeshBuilder& builder,
                                                              const std::string& more = "") {
  ContactParts parts(builder, general_contact(more));
  choose_feature_edges(parts.definition.surface_options, parts.model.surfaces.surfaces, parts.kinematics,
                       parts.contact_mesh);
  ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {});
  parts.find_candidates(search);
  EdgePairLists lists;
  search.find_edge_pairs(parts.kinematics, parts.motion(), {}, lists);
  std::set<std::pair<std::size_t, std::size_t>> blocks;
  const auto block_of = [&](EdgeIndex edge) {
    return parts.mesh.block_of(parts.contact_mesh.edges[edge].side.element());
  };
  for (const EdgeIndex first : lists.rows()) {
    for (const EdgeIndex second : lists.of(first)) {
      CHECK(first < second);
      blocks.insert({block_of(first), block_of(second)});
    }
  }
  return blocks;
}

/// A block with a sharp edge up along x, a rod that crosses over it, and a ball beside both.
MeshBuilder bar_rod_and_ball() {
  MeshBuilder b = crossed_bars(5.0);
  add_rod(b, {.id = 3, .from = {0.3, -1, 0.12}, .to = {0.3, 1, 0.12}});
  add_balls(b, 4, {{0.1, 0, 0.12}}, 0.1);
  return b;
}

}  // namespace

TEST_CASE("the opposite skins of a plate do not meet, however thin it is; those of two plates do",
          "[contact][contact_search]") {
  const std::string formulation = GENERATE("", "constraint formulation = node_face\n");
  const int n_layers = GENERATE(1, 2);
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {6, 6, n_layers}, .size = {6, 6, 0.05}});
  b.add_hexes(
      {.id = 2, .cells = {1, 1, 1}, .origin = {2.2, 2.2, 0.06}, .size = {1, 1, 1}, .share_nodes = false});
  ContactParts parts(b, general_contact("self contact = on\n" + formulation));
  parts.search();
  const Pairs faces = in_set(parts.face_partners);
  std::size_t n_nodes = 0;
  for (const auto& [row, face] : in_set(parts.node_faces))
    n_nodes +=
        parts.contact_mesh.surface_nodes[{row}].surface != parts.contact_mesh.faces[{face}].surface ? 1 : 0;
  CHECK((formulation.empty() ? faces.size() : n_nodes) > 0);
  for (const auto& [first, second] : faces)
    CHECK(parts.contact_mesh.faces[{first}].surface != parts.contact_mesh.faces[{second}].surface);
}

TEST_CASE("a rigid body does not meet itself, two rigid bodies do", "[contact][contact_search]") {
  const std::string formulation = GENERATE("", "constraint formulation = node_face\n");
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 1}, .size = {2, 2, 1}});
  b.add_hexes({.id = 2, .origin = {0.3, 0.4, 0.98}, .share_nodes = false});
  ContactParts parts(b, general_contact(formulation));
  const auto n_nodes = static_cast<std::size_t>(parts.mesh.coordinates().cols());
  constexpr std::size_t n_of_first = 3 * 3 * 2;
  for (const OptionalIndex<std::uint32_t> second :
       {OptionalIndex<std::uint32_t>(0), OptionalIndex<std::uint32_t>(1), OptionalIndex<std::uint32_t>()}) {
    std::vector<OptionalIndex<std::uint32_t>> body_of(n_nodes, second);
    std::fill_n(body_of.begin(), n_of_first, 0);
    ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {}, body_of);
    parts.find_candidates(search);
    const std::size_t n_found = parts.face_partners.partners.size() + parts.node_faces.partners.size();
    CHECK((n_found == 0) == (second == OptionalIndex<std::uint32_t>(0)));
  }
}

TEST_CASE("faces meet faces under FACE_FACE and nodes under NODE_FACE, but balls faces under either",
          "[contact][contact_search]") {
  const bool has_nodes = GENERATE(false, true);
  MeshBuilder b = stacked_cubes(0.01);
  add_balls(b, 3, {{0.5, -0.11, 0.5}}, 0.1);
  ContactParts parts(b, general_contact(has_nodes ? node_face : ""));
  parts.search();
  CHECK(parts.face_partners.partners.empty() == has_nodes);
  std::size_t n_of_nodes = 0, n_of_balls = 0;
  for (const auto& [row, face] : in_set(parts.node_faces)) {
    const bool is_ball = parts.contact_mesh.surface_nodes[{row}].radius > 0.0f;
    (is_ball ? n_of_balls : n_of_nodes) += 1;
  }
  CHECK(n_of_balls > 0);
  CHECK((n_of_nodes > 0) == has_nodes);
}

TEST_CASE("of a pair with sides the nodes of side B meet the faces of side A, and none the other way",
          "[contact][contact_search]") {
  const bool upper_is_b = GENERATE(false, true);
  ContactParts parts(stacked_cubes(0.01), "skin all blocks = on\nbegin interaction\n" + node_face +
                                              (upper_is_b ? "side a = block_1\nside b = block_2\nend\n"
                                                          : "side a = block_2\nside b = block_1\nend\n"));
  parts.search();
  const Pairs pairs = in_set(parts.node_faces);
  CHECK(!pairs.empty());
  const SurfaceIndex side_b{upper_is_b ? 1u : 0u};
  for (const auto& [row, face] : pairs) {
    CHECK(parts.contact_mesh.surface_nodes[{row}].surface == side_b);
    CHECK(parts.contact_mesh.faces[{face}].surface != side_b);
  }
}

TEST_CASE("what only ties is looked for once", "[contact][contact_search]") {
  const std::string form = formulation();
  for (const bool ties : {false, true}) {
    ContactParts parts(stacked_cubes(0.01), general_contact(form + (ties ? "friction model = tied\n" : "")));
    ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {});
    parts.find_candidates(search);
    const std::size_t at_first = parts.face_partners.partners.size() + parts.node_faces.partners.size();
    parts.find_candidates(search);
    CHECK(at_first > 0);
    CHECK(parts.face_partners.partners.size() + parts.node_faces.partners.size() == (ties ? 0 : at_first));
  }
}

TEST_CASE("faces that stand beside each other are candidates where something may hold them",
          "[contact][contact_search]") {
  // The sides of two cubes that stand next to each other look the same way.
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_hexes({.id = 2, .origin = {1.01, 0, 0}, .share_nodes = false});
  const auto has_beside = [&](const std::string& lines) {
    ContactParts parts(b, general_contact(lines));
    parts.search();
    bool has = false;
    for (const auto& [first, second] : in_set(parts.face_partners)) {
      const auto normal = [&](std::uint32_t face) {
        return Vector3d(parts.kinematics.area(parts.contact_mesh.faces[{face}]).normalized());
      };
      has = has || normal(first).dot(normal(second)) > 0.9;
    }
    CHECK(!parts.face_partners.partners.empty());
    return has;
  };
  CHECK_FALSE(has_beside(""));
  CHECK(has_beside("friction model = tied\n"));
  CHECK(has_beside("initial clearance = 0.0\n"));
  CHECK(has_beside("interaction behavior = infinitesimal_sliding\n"));
}

TEST_CASE("edges of rods meet sharp edges and balls, balls no sharp edges",
          "[contact][contact_search][edges]") {
  using Blocks = std::set<std::pair<std::size_t, std::size_t>>;
  const Blocks found = blocks_of_edges(bar_rod_and_ball());
  CHECK(found.contains({2, 3}));
  CHECK(found.contains({2, 0}));
  CHECK_FALSE(found.contains({3, 0}));
  CHECK_FALSE(found.contains({0, 3}));
  CHECK_FALSE(found.contains({0, 0}));
  CHECK(blocks_of_edges(crossed_bars(0.01)).contains({0, 1}));
  CHECK(blocks_of_edges(crossed_bars(0.01), "friction model = tied\n").empty());
}

TEST_CASE("rods that are joined do not meet, of one block or of two", "[contact][contact_search][edges]") {
  const bool of_two = GENERATE(false, true);
  MeshBuilder b;
  add_rod(b, {.id = 1, .cells = of_two ? 1 : 2, .from = {0, 0, 0}, .to = {of_two ? 1.0 : 2.0, 0, 0}});
  if (of_two) add_rod(b, {.id = 2, .from = {1, 0, 0}, .to = {2, 0, 0}});
  CHECK(blocks_of_edges(b, "self contact = on\n").empty());
  add_rod(b, {.id = 3, .from = {0.5, -1, 0.2}, .to = {0.5, 1, 0.2}});
  CHECK(blocks_of_edges(b, "self contact = on\n").size() == 1);
}

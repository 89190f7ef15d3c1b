// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/tied/make_ties.hpp"

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A floor of 4 x 4 unit cells and a cube of edge 1.5 above it, over cells of 2 x 2.
MeshBuilder cube_over_floor(double gap) {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {4, 4, 1}, .size = {4, 4, 1}});
  b.add_hexes({.id = 2, .origin = {0.25, 0.25, 1.0 + gap}, .size = {1.5, 1.5, 1.5}, .share_nodes = false});
  return b;
}

struct TiedBodies : ContactParts {
  TiedBodies(double gap, const std::string& lines)
      : ContactParts(cube_over_floor(gap),
                     general_contact("friction model = tied\npenalty stiffness = 1000\n" + lines)) {
    search();
    ties = make_ties(context(), face_partners, node_faces, definition.dash.search_length_scaling);
  }
  std::vector<Tie> ties;

  double area() const {
    double sum = 0.0;
    for (const Tie& tie : ties) sum += tie.area;
    return sum;
  }
};

}  // namespace

TEST_CASE("faces near each other are tied over their whole overlap", "[contact][make_ties]") {
  for (const double gap : {0.05, -0.05}) {
    const TiedBodies tied(gap, "");
    REQUIRE(tied.ties.size() == 4);
    CHECK(tied.area() == Approx(2.25));
    for (const Tie& tie : tied.ties) {
      CHECK(!tie.is_node);
      CHECK(!tie.is_swapped);
      CHECK(tie.area == Approx(0.5625));
      CHECK(tied.contact_mesh.faces[tie.first_face()].surface == SurfaceIndex{0});
      CHECK(tied.contact_mesh.faces[tie.second].surface == SurfaceIndex{1});
      for (std::size_t k = 0; k < 4; ++k) {
        CHECK(tie.nodes[k] == tied.contact_mesh.faces[tie.first_face()].corners[k]);
        CHECK(tie.nodes[k + 4] == tied.contact_mesh.faces[tie.second].corners[k]);
      }
      // Moved alike, nothing pulls.
      CHECK(tie.stiffness.rowwise().sum().norm() < 1e-10);
    }
  }
}

TEST_CASE("ties reach as far as the capture tolerance, else the normal tolerance, else a share of the face",
          "[contact][make_ties]") {
  CHECK(TiedBodies(0.149, "").ties.size() == 4);
  CHECK(TiedBodies(0.151, "").ties.empty());
  CHECK(TiedBodies(0.1, "normal tolerance = 0.09\n").ties.empty());
  CHECK(TiedBodies(0.1, "normal tolerance = 0.11\n").ties.size() == 4);
  CHECK(TiedBodies(0.1, "normal tolerance = 0.11\ncapture tolerance = 0.09\n").ties.empty());
  CHECK(TiedBodies(0.1, "normal tolerance = 0.09\ncapture tolerance = 0.11\n").ties.size() == 4);
}

TEST_CASE("a capture tolerance far beyond the search's margins ties all the same", "[contact][make_ties]") {
  const double gap = 2.5;  // margins are a share of faces of edge 1 and 1.5
  const std::string by_nodes = "constraint formulation = node_face\n";
  CHECK(TiedBodies(gap, "capture tolerance = 2.51\n").ties.size() == 4);
  CHECK(TiedBodies(gap, "capture tolerance = 2.49\n").ties.empty());
  CHECK(TiedBodies(gap, "capture tolerance = 2.51\n" + by_nodes).ties.size() == 5);
  CHECK(TiedBodies(gap, "capture tolerance = 2.49\n" + by_nodes).ties.empty());
}

TEST_CASE("nodes of a node set and particles are tied to the face that they touch", "[contact][make_ties]") {
  const bool is_particle = GENERATE(true, false);
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 1}, .size = {2, 2, 1}});
  const double radius = is_particle ? 0.1 : 0.0;
  add_balls(b, 2, {{0.5, 0.25, 1.0 + radius}, {1.5, 1.5, 2.0}}, 0.1);
  b.add_node_set(7, "", [](const Eigen::Vector3d& x) {
    return x.z() > 1.0 + 1e-9 || (x - Eigen::Vector3d(0.5, 0.25, 1)).norm() < 1e-9;
  });
  const std::string other = is_particle ? "contact surface other contains block_2\n"
                                        : "contact node set other contains nodelist_7\n";
  ContactParts parts(b, "contact surface floor contains block_1\n" + other +
                            "begin interaction\nside a = floor\nside b = other\nfriction model = tied\n"
                            "constraint formulation = node_face\nend\n");
  parts.search();
  const auto ties = make_ties(parts.context(), parts.face_partners, parts.node_faces, 0.15);
  REQUIRE(ties.size() == 1);
  CHECK(ties[0].is_node);
  CHECK(parts.x.col(parts.contact_mesh.mesh_nodes[ties[0].nodes[0]].value).y() == 0.25);
  CHECK(ties[0].share == 1.0);
}

TEST_CASE("each node that stands over a face is tied once, to the nearest", "[contact][make_ties]") {
  const TiedBodies tied(0.05, "constraint formulation = node_face\n");
  // The cube's four lower nodes, and the one node of the floor under the middle of the cube.
  REQUIRE(tied.ties.size() == 5);
  int n_of_cube = 0;
  for (const Tie& tie : tied.ties) {
    CHECK(tie.is_node);
    const SurfaceNode& node = tied.contact_mesh.surface_nodes[tie.row()];
    CHECK(tie.nodes[0] == node.node);
    CHECK(tie.nodes[3] == node.node);
    CHECK(tied.contact_mesh.faces[tie.second].surface != node.surface);
    CHECK(tie.is_swapped == (node.surface == SurfaceIndex{1}));
    n_of_cube += node.surface == SurfaceIndex{1} ? 1 : 0;
    // A node of the cube stands a quarter of the way to the node under the cube in each direction; of the
    // face over that one all corners are tied.
    const double share = node.surface == SurfaceIndex{1} ? 1.0 - 0.5 * 0.25 * 0.25 : 0.5;
    CHECK(tie.share == Approx(share));
    CHECK(tie.area == Approx(share * (node.surface == SurfaceIndex{1} ? 0.5625 : 1.0)));
    CHECK(tie.stiffness(0, 0) == Approx(1000.0 * tie.area));
  }
  CHECK(n_of_cube == 4);
}

TEST_CASE("nothing is tied that slides, is not active or looks away", "[contact][make_ties]") {
  ContactParts sliding(cube_over_floor(0.05), general_contact());
  sliding.search();
  CHECK(!sliding.face_partners.partners.empty());
  CHECK(make_ties(sliding.context(), sliding.face_partners, sliding.node_faces, 0.15).empty());
  TiedBodies tied(0.05, "");
  tied.rules.activate(0.0, false);
  CHECK(make_ties(tied.context(), tied.face_partners, tied.node_faces, 0.15).empty());
  tied.rules.activate(0.0, true);
  CHECK(make_ties(tied.context(), tied.face_partners, tied.node_faces, 0.15).size() == 4);
}

TEST_CASE("a tie can be made of two faces, or a node and a face, at any gap", "[contact][make_ties]") {
  TiedBodies tied(0.05, "");
  const Tie& known = tied.ties.front();
  tied.x.rightCols(8).row(2).array() += 0.4;
  tied.move();
  CHECK(!make_face_tie(tied.context(), known.first_face(), known.second, 0.4));
  const auto made = make_face_tie(tied.context(), known.first_face(), known.second, 0.5);
  REQUIRE(made);
  CHECK(made->area == Approx(0.5625));
  for (const SurfaceNodeIndex row : tied.contact_mesh.rows_of({1})) {
    const Eigen::Vector3d x = tied.kinematics.x(tied.contact_mesh.surface_nodes[row].node);
    const bool is_over = x.z() < 2.0 && x.x() < 1.0 && x.y() < 1.0;
    CHECK(make_node_tie(tied.context(), {row.value, known.first_face(), known.pair, true, 0.5}).has_value() ==
          is_over);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/node_face/node_face_history.hpp"

#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/contact_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// Two cubes of 16 surface nodes, which touch as nodes.
struct RememberedNodes {
  ContactParts parts{cube_over_cube(0.0), general_contact("constraint formulation = node_face\n")};
  NodeFaceHistory history{16};

  static ContactPoint point(std::uint32_t row, double gap, const Vector3d& normal = Vector3d::UnitZ()) {
    ContactPoint made;
    made.first_entity = row;
    made.second_entity = 1;
    made.first.weights = made.second.weights = Eigen::Vector4d::UnitX();
    made.normal = normal;
    made.force = gap < 0.0 ? 1.0 : 0.0;
    made.gap = gap;
    made.elastic_slip << 0.1 * (row + 1), 0, 0;
    return made;
  }
  void step(const std::vector<ContactPoint>& points, bool balances = false) {
    ContactStepContext context = parts.context(0.1);
    context.balances = balances;
    history.update(context, 0, points);
  }
  std::vector<LostContact> lost() const {
    std::vector<LostContact> found;
    history.find_lost(found);
    return found;
  }
};

}  // namespace

TEST_CASE("a node knows the faces that look the way of those that it touched",
          "[contact][node_face_history]") {
  RememberedNodes nodes;
  CHECK_FALSE(nodes.history.of({3}).knows(Vector3d::UnitZ()));
  nodes.step({RememberedNodes::point(3, -0.25), RememberedNodes::point(4, 0.1)});
  const NodeHistory node = nodes.history.of({3});
  CHECK(node.knows(Vector3d::UnitZ()));
  CHECK(node.knows(Vector3d(0, 0.8, 0.6)));
  CHECK_FALSE(node.knows(Vector3d(0, 0.9, 0.4)));
  CHECK_FALSE(node.knows(-Vector3d::UnitZ()));
  CHECK(node.touched({0}, Vector3d::UnitZ()));
  CHECK_FALSE(node.touched({1}, Vector3d::UnitZ()));
  CHECK(node.depth(Vector3d(0, 0.8, 0.6)) == 0.25);
  CHECK(node.depth(Vector3d::UnitX()) == 0.0);
  // The slip is that of almost the same way only.
  CHECK(node.elastic_slip(Vector3d(0, 0.6, 0.8)).isApprox(Vector3d(0.4, 0, 0)));
  CHECK(node.elastic_slip(Vector3d(0, 0.8, 0.6)).isZero(0.0));
  CHECK(nodes.history.of({4}).face_histories.empty());
  CHECK(nodes.history.of({2}).face_histories.empty());
}

TEST_CASE("a node in a hollow knows each of its walls", "[contact][node_face_history]") {
  RememberedNodes nodes;
  nodes.step({RememberedNodes::point(3, -0.25), RememberedNodes::point(3, -0.125, Vector3d::UnitX())});
  const NodeHistory node = nodes.history.of({3});
  CHECK(node.face_histories.size() == 2);
  CHECK(node.depth(Vector3d::UnitZ()) == 0.25);
  CHECK(node.depth(Vector3d::UnitX()) == 0.125);
  CHECK(nodes.history.depths(16)[3] == 0.25f);
  CHECK(nodes.history.depths(16)[2] == 0.0f);
}

TEST_CASE("points of the penalty and of momentum balance are remembered apart",
          "[contact][node_face_history]") {
  RememberedNodes nodes;
  ContactPoint balanced = RememberedNodes::point(5, -0.5);
  balanced.is_balanced = true;
  nodes.step({RememberedNodes::point(3, -0.25)});
  nodes.step({balanced}, true);
  CHECK(nodes.history.of({3}).knows(Vector3d::UnitZ()));
  CHECK(nodes.history.of({5}).knows(Vector3d::UnitZ()));
  nodes.step({});
  CHECK_FALSE(nodes.history.of({3}).knows(Vector3d::UnitZ()));
  CHECK(nodes.history.of({5}).knows(Vector3d::UnitZ()));
}

TEST_CASE("nodes whose deep contact ends are lost in that step", "[contact][node_face_history]") {
  RememberedNodes nodes;
  nodes.step({RememberedNodes::point(3, -0.75), RememberedNodes::point(5, -0.25)});
  CHECK(nodes.lost().empty());
  nodes.history.begin_step();
  nodes.step({});
  REQUIRE(nodes.lost().size() == 1);
  CHECK(nodes.lost()[0].node == nodes.parts.contact_mesh.surface_nodes[{3}].node);
  CHECK(nodes.lost()[0].depth == 0.75);
  nodes.history.begin_step();
  nodes.step({});
  CHECK(nodes.lost().empty());
  nodes.step({RememberedNodes::point(3, -0.75)});
  nodes.history.begin_step();
  nodes.step({RememberedNodes::point(3, -0.125, Vector3d::UnitX())});  // it goes on somewhere
  CHECK(nodes.lost().empty());
}

TEST_CASE("after deaths nodes are known by their new numbers, and none is lost",
          "[contact][node_face_history]") {
  RememberedNodes nodes;
  nodes.step({RememberedNodes::point(1, -0.25), RememberedNodes::point(3, -0.75),
              RememberedNodes::point(6, -0.125)});
  ContactRemap remap;
  remap.n_rows_after = 8;
  for (std::uint32_t i = 0; i < 16; ++i) {
    // Of lofts rows may change their order.
    remap.rows.push_back(i == 3   ? OptionalIndex<SurfaceNodeIndex>(SurfaceNodeIndex{7})
                         : i == 6 ? OptionalIndex<SurfaceNodeIndex>(SurfaceNodeIndex{2})
                                  : std::nullopt);
  }
  nodes.history.remap(remap);
  CHECK(nodes.history.of({7}).depth(Vector3d::UnitZ()) == 0.75);
  CHECK(nodes.history.of({2}).depth(Vector3d::UnitZ()) == 0.125);
  CHECK(nodes.history.of({1}).face_histories.empty());
  nodes.history.begin_step();
  nodes.step({});
  CHECK(nodes.lost().empty());
}

TEST_CASE("nodes go on from a stored state", "[contact][node_face_history]") {
  RememberedNodes nodes, others;
  nodes.step({RememberedNodes::point(3, -0.75)});
  others.step({RememberedNodes::point(9, -0.75)});
  StateArchive saves;
  nodes.history.archive(saves);
  const SavedState saved = saves.take();
  StateArchive restores(saved);
  others.history.archive(restores);
  CHECK(others.history.of({9}).face_histories.empty());
  CHECK(others.history.of({3}).depth(Vector3d::UnitZ()) == 0.75);
  CHECK(others.history.of({3}).elastic_slip(Vector3d::UnitZ()).isApprox(Vector3d(0.4, 0, 0)));
  others.history.begin_step();
  others.step({});
  CHECK(others.lost().size() == 1);
}

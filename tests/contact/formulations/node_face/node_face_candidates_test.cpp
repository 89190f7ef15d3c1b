// SPDX-License-Identifier: BSD-3-Clause
// The candidates of nodes, and what is remembered of them from search to search and over deaths.
#include <algorithm>

#include "contact/formulations/node_face/node_face_contacts.hpp"
#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/contact_death.hpp"
#include "support/contact_faces.hpp"
#include "support/stacked_cubes.hpp"
#include "support/tip_on_floor.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// Nodes of cubes of 2 x 2 x 2 cells, the upper one so far above the lower one, that meet faces.
struct NodesOfCubes : ContactParts {
  explicit NodesOfCubes(double gap, const std::string& lines = "")
      : ContactParts(stacked_cubes(gap, 2, 0.1), general_contact(node_face + lines)), contacts(setup()) {
    search();
    contacts.take_candidates(node_faces);
  }
  NodeFaceContacts contacts;

  /// At the bottom of the upper cube, or the top of the lower one.
  bool is_at_joint(SurfaceNodeIndex row) const {
    return std::abs(kinematics.x(contact_mesh.surface_nodes[row].node).z() - 1.0) < 0.2;
  }
};

const std::string hybrid_nodes =
    "friction model = h\ncapture tolerance = 0.01\nend\n"
    "begin constant friction model rough\nfriction coefficient = 0.5\nend\n"
    "begin hybrid model h\ninitially close = rough\n";

}  // namespace

TEST_CASE("bounds are needed of the faces of a node and of all around those that it may touch",
          "[contact][node_face_contacts]") {
  NodesOfCubes cubes(0.02);
  IndexedVector<FaceIndex, std::uint8_t> is_watched(cubes.contact_mesh.faces.size(), 0);
  cubes.contacts.watch(is_watched);
  // Slowly: faces with a corner that is a node with candidates, or a corner of a candidate.
  const auto& faces = cubes.contact_mesh.faces;
  const auto is_needed = [&](FaceIndex face) {
    const auto has = [&](ContactNodeIndex node) {
      return std::ranges::find(faces[face].corners, node) != faces[face].corners.end();
    };
    for (const SurfaceNodeIndex row : cubes.node_faces.rows()) {
      if (cubes.node_faces.of(row).empty()) continue;
      if (has(cubes.contact_mesh.surface_nodes[row].node)) return true;
      for (const FaceIndex partner : cubes.node_faces.of(row)) {
        if (std::ranges::any_of(faces[partner].corners, has)) return true;
      }
    }
    return false;
  };
  std::size_t n_watched = 0;
  for (const FaceIndex face : indices(faces)) {
    CHECK((is_watched[face] == 1) == is_needed(face));
    n_watched += is_watched[face];
  }
  CHECK(n_watched > 8);
  CHECK(n_watched < faces.size());  // not those far from the joint
}

TEST_CASE("of a HYBRID pair the nodes within the tolerance of what they look at are close",
          "[contact][node_face_contacts]") {
  const double gap = GENERATE(0.005, 0.05);
  NodesOfCubes cubes(gap, hybrid_nodes);
  cubes.contacts.mark_close(cubes.context(), 0.05, cubes.rules);
  std::size_t n_close = 0;
  for (const SurfaceNodeIndex row : indices(cubes.contact_mesh.surface_nodes)) {
    if (!(cubes.rules.of_node({0}, row).friction > 0.0)) continue;
    ++n_close;
    CHECK(cubes.is_at_joint(row));
  }
  // All at the joint but the three of each cube that stand beside the other one.
  CHECK(n_close == (gap < 0.01 ? 12 : 0));
}

TEST_CASE("nodes of a pair that has to know its start get the gap to what they stand over",
          "[contact][node_face_contacts]") {
  NodesOfCubes cubes(0.02, "initial clearance = 0.01\n");
  FoundStartGaps gaps;
  cubes.contacts.add_start_gaps(cubes.context(), gaps);
  CHECK(gaps.faces.empty());
  CHECK(gaps.edges.empty());
  REQUIRE(gaps.nodes.size() == 12);
  CHECK(std::ranges::is_sorted(gaps.nodes, {}, &StartGap::entity));
  for (const StartGap& gap : gaps.nodes) {
    CHECK(cubes.is_at_joint({gap.entity}));
    CHECK(gap.mean == Approx(0.02));
  }
  NodesOfCubes other(0.02);
  FoundStartGaps none;
  other.contacts.add_start_gaps(other.context(), none);
  CHECK(none.nodes.empty());
}

TEST_CASE("a node goes on in faces that have got other numbers, as deep as it was",
          "[contact][node_face_contacts]") {
  TipOnFloor parts;
  parts.put({1.5, 1.5, 0.02});
  for (const double depth : {0.1, 0.3, 0.5}) REQUIRE(parts.put({1.5, 1.5, -depth}, true).size() == 1);
  const FaceIndex before = parts.look(1.0)[0].second_face();
  // The first cell dies, which is far from the node: what it exposes is new.
  const auto cells = parts.mesh.blocks()[2];
  const auto remap = let_die(parts,
                             general_contact("penalty stiffness = 1000\n",
                                             "contact surface floor contains block_1\n"
                                             "contact node set tip contains tip\n"),
                             {std::int64_t{cells.first_element.value} + 1});
  parts.contacts.remap(remap);
  CHECK(parts.contacts.n_rows() == parts.contact_mesh.surface_nodes.size());
  const auto points = parts.look(1.0);
  REQUIRE(points.size() == 1);
  CHECK(points[0].gap == Approx(-0.5));
  CHECK(points[0].second_face().value != before.value);
  CHECK(
      (parts.kinematics.area(parts.contact_mesh.faces[points[0].second_face()]) - Vector3d::UnitZ()).norm() <
      1e-12);
}

TEST_CASE("candidates of nodes and how deep they were go on from a stored state",
          "[contact][node_face_contacts]") {
  TipOnFloor parts;
  parts.put({0.5, 0.5, 0.02});
  for (const double depth : {0.1, 0.3, 0.5}) REQUIRE(parts.put({0.5, 0.5, -depth}, true).size() == 1);
  StateArchive saves;
  parts.contacts.archive(saves);
  const SavedState stored = saves.take();
  NodeFaceContacts other(parts.setup());
  StateArchive restores(stored);
  other.archive(restores);
  CHECK(other.candidates().partners == parts.contacts.candidates().partners);
  CHECK(other.depths() == parts.contacts.depths());
  std::vector<ContactPoint> points;
  other.begin_detection(parts.context(1.0));
  other.detect(parts.context(1.0), {0, other.n_rows()}, points);
  REQUIRE(points.size() == 1);
  CHECK(points[0].gap == Approx(-0.5));
}

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/penetration_depths.hpp"

#include "support/catch.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using Eigen::Vector3d;
using test::ContactParts;

namespace {

/// Two unit cubes above each other, of one face a side; surface 0 is the lower one.
struct Cubes : ContactParts {
  Cubes() : ContactParts(test::stacked_cubes(0.0), test::general_contact()) {
    depths.begin_step(contact_mesh);
  }
  /// The face of a surface whose normal is along z.
  FaceIndex face(std::uint32_t surface, double z) const {
    for (const FaceIndex i : indices(contact_mesh.faces)) {
      const ContactFace& one = contact_mesh.faces[i];
      if (one.surface == SurfaceIndex{surface} && kinematics.area(one).normalized().z() * z > 0.9) return i;
    }
    throw std::logic_error("no such face");
  }
  void note(const ContactPoint& point) { depths.note(kinematics, point); }
  double depth_after(FaceIndex face) {
    depths.begin_step(contact_mesh);
    return depths.of(face);
  }

  PenetrationDepths depths;
  const FaceIndex top = face(0, 1.0), bottom = face(1, -1.0), upper_top = face(1, 1.0);
};

/// The bottom of the upper cube in the top of the lower one.
ContactPoint faces_point(const Cubes& cubes, double gap) {
  ContactPoint point;
  point.first_entity = cubes.bottom.value;
  point.second_entity = cubes.top.value;
  point.first.nodes = {0, 1, 2, 3};
  point.first.weights.setConstant(0.25);
  point.second.weights.setConstant(0.25);
  point.normal = Vector3d::UnitZ();
  point.gap = gap;
  return point;
}

}  // namespace

TEST_CASE("the depth of a face is the largest of the step before", "[contact][penetration_depths]") {
  Cubes cubes;
  cubes.note(faces_point(cubes, -0.02));
  cubes.note(faces_point(cubes, -0.05));
  cubes.note(faces_point(cubes, -0.01));
  CHECK(cubes.depths.of(cubes.top) == 0.0);  // of this step, not known yet
  CHECK(cubes.depth_after(cubes.top) == 0.05);
  CHECK(cubes.depths.of(cubes.bottom) == 0.05);
  CHECK(cubes.depths.of(cubes.upper_top) == 0.0);
  for (const ContactNodeIndex node : cubes.contact_mesh.nodes()) {
    INFO("contact node " << node.value);
    const auto has_corner = [&](FaceIndex face) {
      return std::ranges::count(cubes.contact_mesh.faces[face].corners, node) > 0;
    };
    CHECK(cubes.depths.has_touched_at(node) == (has_corner(cubes.top) || has_corner(cubes.bottom)));
  }
  CHECK(cubes.depth_after(cubes.top) == 0.0);  // nothing was noted since
}

TEST_CASE("what touches without depth has touched all the same", "[contact][penetration_depths]") {
  Cubes cubes;
  ContactPoint point = faces_point(cubes, 0.01);
  cubes.note(point);
  CHECK(cubes.depth_after(cubes.top) == 0.0);
  SECTION("by a force") { point.force = 1.0; }
  SECTION("in balance of momentum") { point.is_balanced = true; }
  cubes.note(point);
  const double depth = cubes.depth_after(cubes.top);
  const bool is_changed = point.force > 0.0 || point.is_balanced;
  CHECK((depth > 0.0) == is_changed);
  CHECK(depth < 1e-300);
}

TEST_CASE("points of edges say nothing of faces", "[contact][penetration_depths]") {
  Cubes cubes;
  ContactPoint point = faces_point(cubes, -0.02);
  point.is_of_edges = true;
  cubes.note(point);
  CHECK(cubes.depth_after(cubes.top) == 0.0);
}

TEST_CASE("of a node its own faces that are turned to the other side are as deep",
          "[contact][penetration_depths]") {
  Cubes cubes;
  const ContactFace& bottom = cubes.contact_mesh.faces[cubes.bottom];
  const auto row = cubes.contact_mesh.find_row(bottom.corners[0], SurfaceIndex{1});
  REQUIRE(row);
  ContactPoint point = faces_point(cubes, -0.03);
  point.first_entity = row->value;
  point.first.nodes.fill(bottom.corners[0]);
  point.first.weights = {1, 0, 0, 0};
  cubes.note(point);
  CHECK(cubes.depth_after(cubes.bottom) == 0.03);
  CHECK(cubes.depths.of(cubes.top) == 0.03);
  // The sides of the upper cube at that node stand across the normal.
  for (const FaceIndex i : indices(cubes.contact_mesh.faces)) {
    if (i != cubes.bottom && i != cubes.top) CHECK(cubes.depths.of(i) == 0.0);
  }
}

TEST_CASE("a rigid side has no face that could be deep", "[contact][penetration_depths]") {
  Cubes cubes;
  ContactPoint point = faces_point(cubes, -0.03);
  point.second.weights.setZero();
  cubes.note(point);
  CHECK(cubes.depth_after(cubes.bottom) == 0.03);
  CHECK(cubes.depths.of(cubes.top) == 0.0);
}

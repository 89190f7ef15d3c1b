// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/flush_rims.hpp"

#include "contact/formulations/penetration_depths.hpp"
#include "contact/mesh/feature_edges.hpp"
#include "support/catch.hpp"
#include "support/contact_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// Two blocks flush beside each other, and a third one on them, whose left side is right beyond the joint: it
/// meets the right side of the first block inside the joint, by the strip that it is deep.
struct FlushBlocks {
  ContactParts parts;
  PenetrationDepths depths;
  FaceIndex in_joint, side, bottom;

  explicit FlushBlocks(double deep, double touched) : parts(blocks(deep), general_contact()) {
    measure_sharpness(parts.kinematics, parts.contact_mesh);
    in_joint = face_of(parts, 0, Vector3d::UnitX());
    side = face_of(parts, 2, -Vector3d::UnitX());
    bottom = face_of(parts, 2, -Vector3d::UnitZ());
    depths.begin_step(parts.contact_mesh);
    if (touched > 0.0) {
      ContactPoint point;
      point.first_entity = bottom.value;
      point.second_entity = face_of(parts, 1, Vector3d::UnitZ()).value;
      point.first.nodes = parts.contact_mesh.faces[bottom].corners;
      point.second.nodes = parts.contact_mesh.faces[point.second_face()].corners;
      point.first.weights.setConstant(0.25);
      point.second.weights.setConstant(0.25);
      point.normal = Vector3d::UnitZ();
      point.force = 1.0;
      point.gap = -touched;
      depths.note(parts.kinematics, point);
    }
    depths.begin_step(parts.contact_mesh);
  }
  static MeshBuilder blocks(double deep) {
    MeshBuilder b;
    b.add_hexes({.id = 1});
    b.add_hexes({.id = 2, .origin = {1, 0, 0}, .share_nodes = false});
    return b.add_hexes({.id = 3, .origin = {0.999, 0, 1.0 - deep}, .share_nodes = false});
  }
  ContactStepContext context() const {
    ContactStepContext context = parts.context(0.1);
    context.depths = &depths;
    return context;
  }
  /// Of the faces inside the joint.
  bool is_flush(bool is_turned_round = false) const {
    PairPenalty penalty;
    penalty.stiffness = 1.0;
    penalty.depth = 0.5;
    const FaceIndex first = is_turned_round ? side : in_joint, second = is_turned_round ? in_joint : side;
    const FaceFaceContact contact =
        find_face_face_contact(parts.kinematics.face(first), parts.kinematics.face(second), penalty, 0.0);
    REQUIRE(contact.overlaps);
    const ContactStepContext now = context();
    FlushStrips strips(now, first, second);
    FaceFaceContact large = contact;
    large.area = 1e6;  // no sliver
    CHECK_FALSE(strips.hold(large));
    const bool holds = strips.hold(contact);
    CHECK(strips.hold(contact) == holds);
    return holds;
  }
};

}  // namespace

TEST_CASE("the strip of a side face below a flush surface is no contact", "[contact][flush_rims]") {
  const FlushBlocks blocks(0.01, 0.01);
  CHECK(blocks.is_flush());
  CHECK(blocks.is_flush(true));
}

TEST_CASE("a strip counts as flush only where the face beyond the rim has touched", "[contact][flush_rims]") {
  CHECK_FALSE(FlushBlocks(0.01, 0.0).is_flush());
  FlushBlocks blocks(0.01, 0.01);
  blocks.depths.begin_step(blocks.parts.contact_mesh);  // and not one step later
  CHECK_FALSE(blocks.is_flush());
}

TEST_CASE("a strip that is much wider than the penetration is a contact", "[contact][flush_rims]") {
  CHECK_FALSE(FlushBlocks(0.2, 0.01).is_flush());
  CHECK(FlushBlocks(0.1, 0.1).is_flush());
}

TEST_CASE("the width of a strip is some times the depth of the last step", "[contact][flush_rims]") {
  const FlushBlocks blocks(0.01, 0.02);
  CHECK(flush_width(blocks.context(), blocks.bottom) == Approx(4.0 * 0.02));
  CHECK(flush_width(blocks.context(), blocks.side) == 0.0);
  CHECK(flush_width(blocks.parts.context(0.1), blocks.bottom) == 0.0);  // nothing is known
}

TEST_CASE("a strip is one by where the faces beyond its rims are now, followed or not",
          "[contact][flush_rims]") {
  FlushBlocks blocks(0.01, 0.01);
  ContactParts& parts = blocks.parts;
  parts.x = (Eigen::AngleAxisd(1.5, Vector3d::UnitX()).toRotationMatrix() * parts.x).eval();
  parts.kinematics.move_nodes(parts.motion());
  parts.kinematics.watch({blocks.in_joint, blocks.side});
  parts.kinematics.bound_watched();
  CHECK(blocks.is_flush());
}

TEST_CASE("nodes of the strip meet no side faces either", "[contact][flush_rims]") {
  const FlushBlocks blocks(0.01, 0.01), others(0.2, 0.01);
  const auto is_flush = [](const FlushBlocks& of) {
    // A lower corner of the third block against the side inside the joint.
    const SurfaceNodeIndex row = row_of_node(of.parts, 16);
    return is_at_flush_rim(of.context(), row, of.in_joint, Vector3d::UnitX());
  };
  CHECK(is_flush(blocks));
  CHECK_FALSE(is_flush(others));
  CHECK_FALSE(is_flush(FlushBlocks(0.01, 0.0)));
}

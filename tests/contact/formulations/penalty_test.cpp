// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/penalty.hpp"

#include "contact/enforcement/penalty_limits.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;

namespace {

/// thickness, stiffness, mass per area
const PenaltyProperties soft{0.2, 100.0, 3.0}, hard{0.1, 300.0, 6.0};

}  // namespace

TEST_CASE("the springs of two sides stand in series", "[contact][penalty]") {
  const SurfacePair pair;
  CHECK(make_pair_penalty(soft, &hard, pair).stiffness == Approx(75.0));
  CHECK(make_pair_penalty(hard, &soft, pair).stiffness == Approx(75.0));
  CHECK(make_pair_penalty(soft, &soft, pair).stiffness == Approx(50.0));
  CHECK(make_pair_penalty(soft, nullptr, pair).stiffness == 100.0);
  // Verification case U4: K/t of 1e11/0.01 and 2e11/0.02.
  const PenaltyProperties first{0.01, 1e11 / 0.01, 1.0}, second{0.02, 2e11 / 0.02, 1.0};
  CHECK(make_pair_penalty(first, &second, pair).stiffness == Approx(5e12).epsilon(1e-12));
}

TEST_CASE("a rigid side has no spring and no mass of its own, two of them have those of their elements",
          "[contact][penalty]") {
  SurfacePair pair;
  pair.damping_fraction = 0.1;
  const double modulus = GENERATE(1e-4, 1.0, 1e4);
  const PenaltyProperties rigid{0.2, 100.0 * modulus, 3.0 * modulus, true};
  const double damping = 0.2 * std::sqrt(300.0 * 6.0);
  CHECK(make_pair_penalty(rigid, &hard, pair).stiffness == 300.0);
  CHECK(make_pair_penalty(hard, &rigid, pair).stiffness == 300.0);
  CHECK(make_pair_penalty(rigid, &hard, pair).damping == Approx(damping));
  CHECK(make_pair_penalty(rigid, &rigid, pair).stiffness == Approx(50.0 * modulus));
}

TEST_CASE("the penalty gets stiffer with depth, one of the pair's own does not", "[contact][penalty]") {
  SurfacePair pair;
  const PairPenalty penalty = make_pair_penalty(soft, &hard, pair);
  CHECK(penalty.law.slope(0.004) == 1.0);
  CHECK(penalty.law.slope(0.05) > 50.0);
  pair.penalty_stiffness = 1e6;
  CHECK(make_pair_penalty(soft, &hard, pair).law.slope(0.05) == 1.0);
}

TEST_CASE("the penalty gets stiffer behind the depth that either side had at the start",
          "[contact][penalty]") {
  PenaltyProperties overlapping = soft;
  overlapping.start_depth = 0.06;
  for (const PairPenalty& penalty : {make_pair_penalty(overlapping, &hard, SurfacePair{}),
                                     make_pair_penalty(hard, &overlapping, SurfacePair{})}) {
    CHECK(penalty.law.spring_depth(0.064) == 0.064);
    CHECK(penalty.law.slope(0.11) == make_pair_penalty(soft, &hard, SurfacePair{}).law.slope(0.05));
  }
}

TEST_CASE("a pair scales the stiffness or has its own", "[contact][penalty]") {
  SurfacePair pair;
  pair.penalty_scale = 0.5;
  CHECK(make_pair_penalty(soft, &hard, pair).stiffness == Approx(37.5));
  pair.penalty_stiffness = 1e6;
  CHECK(make_pair_penalty(soft, &hard, pair).stiffness == Approx(5e5));
  CHECK(make_pair_penalty(soft, nullptr, pair).stiffness == Approx(5e5));
}

TEST_CASE("damping is a share of the critical one of both masses", "[contact][penalty]") {
  SurfacePair pair;
  CHECK(make_pair_penalty(soft, &hard, pair).damping == 0.0);
  pair.damping_fraction = 0.1;
  CHECK(make_pair_penalty(soft, &hard, pair).damping == Approx(0.2 * std::sqrt(75.0 * 2.0)));
  CHECK(make_pair_penalty(soft, nullptr, pair).damping == Approx(0.2 * std::sqrt(100.0 * 3.0)));
}

TEST_CASE("contact reaches half the thinner element deep, or as deep as the pair says",
          "[contact][penalty]") {
  SurfacePair pair;
  CHECK(make_pair_penalty(soft, &hard, pair).depth == Approx(0.05));
  CHECK(make_pair_penalty(soft, nullptr, pair).depth == Approx(0.1));
  pair.normal_tolerance = 0.07;
  CHECK(make_pair_penalty(soft, &hard, pair).depth == 0.07);
}

TEST_CASE("light nodes lower the stiffness alike in the middle and at the edges of a face",
          "[contact][penalty]") {
  // 2 x 2 x 1 elements of density 1, 1 x 1 x 3: behind the top 1.5 of mass per area, behind the sides 0.5.
  test::MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 1}, .size = {2, 2, 3}});
  test::ContactParts parts(b, test::general_contact());
  for (const std::uint32_t node : parts.contact_mesh.mesh_nodes) {
    const Eigen::Vector3d x = parts.x.col(node);
    parts.contact_mesh.mass.push_back(0.375 * (x[0] == 1.0 ? 2.0 : 1.0) * (x[1] == 1.0 ? 2.0 : 1.0));
  }
  for (ContactFace& face : parts.contact_mesh.faces) face.penalty_properties.stiffness = 1e9;
  for (SurfaceNode& node : parts.contact_mesh.surface_nodes) node.penalty_properties.stiffness = 1e9;
  parts.contact_mesh.faces[{0}].penalty_properties.stiffness = 1e-3;
  Model model;
  model.mesh = &parts.mesh;
  limit_stiffness(parts.kinematics, ContactMobility(model), 0.1, parts.contact_mesh);
  CHECK(parts.contact_mesh.faces[{0}].penalty_properties.stiffness == 1e-3);
  for (const FaceIndex f : IndexRange(FaceIndex{1}, parts.contact_mesh.faces.next())) {
    const bool is_side = std::abs(parts.kinematics.bound(f).normal().cast<double>()[2]) < 0.5;
    CHECK(parts.contact_mesh.faces[f].penalty_properties.stiffness ==
          Approx(4.0 * penalty_share * (is_side ? 0.5 : 1.5) * 100.0));
  }
  for (const SurfaceNode& node : parts.contact_mesh.surface_nodes) {
    const Eigen::Vector3d x = parts.x.col(parts.contact_mesh.mesh_nodes[node.node]);
    const bool is_inner = x[0] == 1.0 && x[1] == 1.0;
    CHECK(node.penalty_properties.stiffness == Approx(4.0 * penalty_share * (is_inner ? 1.5 : 0.5) * 100.0));
  }
}

TEST_CASE("faces that are held along their normal, or rigid, have no limit and are rigid",
          "[contact][penalty]") {
  test::MeshBuilder b;
  b.add_hexes({.id = 1});
  test::ContactParts parts(b, test::general_contact());
  parts.contact_mesh.mass.assign(8, 1e-3);
  for (ContactFace& face : parts.contact_mesh.faces) face.penalty_properties.stiffness = 1e9;
  Model model;
  model.mesh = &parts.mesh;
  model.mass = Eigen::Matrix3Xd::Constant(3, 8, 1e-3);
  PrescribedMotion held;
  held.direction = Components{{false, false, true}};
  for (std::uint32_t node = 0; node < 8; ++node) held.nodes.push_back({node});
  const bool is_rigid = GENERATE(false, true);
  if (is_rigid) {
    model.rigid.nodes.body_of.assign(8, 0);
  } else {
    model.kinematic_constraints = KinematicConstraints(parts.mesh, {held});
  }
  ContactMobility mobility(model);
  mobility.update(0.0);
  limit_stiffness(parts.kinematics, mobility, 0.1, parts.contact_mesh);
  for (const FaceIndex f : indices(parts.contact_mesh.faces)) {
    const bool is_side = std::abs(parts.kinematics.bound(f).normal().cast<double>()[2]) < 0.5;
    CHECK(parts.contact_mesh.faces[f].penalty_properties.is_rigid == (is_rigid || !is_side));
    if (!is_rigid && !is_side) CHECK(parts.contact_mesh.faces[f].penalty_properties.stiffness == 1e9);
  }
}

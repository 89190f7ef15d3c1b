// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/decaying_constraints.hpp"

#include <Eigen/Geometry>

#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/two_cubes.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

/// What holds two faces of unit cubes that are 1 apart.
struct Fading {
  CornerVectors x;
  InterfaceConstraint constraint;
  CornerForces at_failure;

  Fading() {
    x << 0, 0, 1, 1, 0, 1, 1, 0,  //
        0, 1, 1, 0, 0, 0, 1, 1,   //
        2, 2, 2, 2, 1, 1, 1, 1;
    at_failure.forces.setZero();
    at_failure.forces.row(2).head<4>().setConstant(-4.0);
    at_failure.forces.row(2).tail<4>().setConstant(4.0);
    at_failure.stored = 6.0;
  }
};

}  // namespace

TEST_CASE("forces of a failed hold fall along a straight line, and what it stores with them",
          "[contact][decaying_constraints]") {
  const Fading fading;
  DecayingConstraint left = make_decaying(fading.constraint, fading.at_failure, fading.x, 4);
  for (int n = 0; n <= 4; ++n) {
    left.n_done = n;
    const CornerForces now = find_decaying_forces(left, fading.x);
    CHECK(now.forces.isApprox((1.0 - n / 4.0) * fading.at_failure.forces));
    CHECK(now.stored == Approx(6.0 * (1.0 - n / 4.0)));
    CHECK(now.normal.isApprox(Vector3d::UnitZ()));
    CHECK(left.is_over() == (n == 4));
  }
}

TEST_CASE("forces of a failed hold turn with the second face and leave no moment",
          "[contact][decaying_constraints]") {
  const Fading fading;
  const DecayingConstraint left = make_decaying(fading.constraint, fading.at_failure, fading.x, 4);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const CornerVectors turned = (turn * fading.x).colwise() + Vector3d(3, 1, -2);
  const CornerForces now = find_decaying_forces(left, turned);
  CHECK(now.forces.isApprox(turn * fading.at_failure.forces, 1e-12));
  // The first side slides away: its forces stay, those of the second take the moment.
  CornerVectors slid = fading.x;
  slid.leftCols<4>().row(0).array() += 0.5;
  const CornerForces after = find_decaying_forces(left, slid);
  CHECK(after.forces.leftCols<4>().isApprox(fading.at_failure.forces.leftCols<4>()));
  Vector3d moment = Vector3d::Zero();
  for (int k = 0; k < 8; ++k) moment += Vector3d(slid.col(k)).cross(Vector3d(after.forces.col(k)));
  CHECK(moment.norm() < 1e-12);
  CHECK(after.forces.rowwise().sum().norm() < 1e-12);
}

TEST_CASE("what a failed hold stores and the work that it takes are lost step by step",
          "[contact][decaying_constraints]") {
  test::TwoCubes cubes(
      "friction model = m\nend\nbegin area weld model m\nnormal capacity = 50\n"
      "tangential capacity = 80\nfailure decay cycles = 3\n");
  test::ContactParts& parts = cubes.parts;
  ConstraintForces failed{{}, Fading().at_failure};
  failed.constraint.nodes = {8, 10, 11, 9, 4, 5, 7, 6};
  DecayingConstraints decaying;
  decaying.add(parts.context(0.1), failed);
  REQUIRE(decaying.constraints().size() == 1);
  std::vector<ConstraintForces> found;
  decaying.step(parts.context(0.0), found);  // before the first step
  ContactStepContext balance = parts.context(0.1);
  balance.balances = true;
  decaying.step(balance, found);
  CHECK(found.empty());
  parts.v.rightCols(8).row(2).setConstant(1.0);
  parts.move();
  StateArchive saves;
  decaying.archive(saves);
  const SavedState saved = saves.take();
  DecayingConstraints other;
  StateArchive restores(saved);
  other.archive(restores);
  for (DecayingConstraints* constraints : {&decaying, &other}) {
    found.clear();
    for (int i = 0; i < 4; ++i) constraints->step(parts.context(0.1), found);
    REQUIRE(found.size() == 3);
    double lost = 0.0;
    for (int n = 1; n <= 3; ++n) {
      const ConstraintForces& now = found[static_cast<std::size_t>(n) - 1];
      CHECK(now.forces.forces(2, 0) == Approx(-4.0 * (1.0 - n / 3.0)).margin(1e-15));
      CHECK(now.fails == (n == 3));
      lost += now.forces.dissipated;
    }
    // 6 that it held, and 16 / 2 along the 0.3 of the three steps.
    CHECK(lost == Approx(6.0 + 0.5 * 16.0 * 0.3));
    CHECK(found[0].forces.dissipated == Approx(2.0 + 16.0 * (5.0 / 6.0) * 0.1));
    CHECK(constraints->constraints().empty());
  }
}

TEST_CASE("what is left of a failed hold ends with a side of it, but not where nothing changes",
          "[contact][decaying_constraints]") {
  test::TwoCubes cubes(
      "friction model = m\nend\nbegin area weld model m\nnormal capacity = 50\n"
      "tangential capacity = 80\nfailure decay cycles = 3\n");
  ConstraintForces failed{{}, Fading().at_failure};
  failed.constraint.nodes = {8, 10, 11, 9, 4, 5, 7, 6};
  DecayingConstraints decaying;
  for (const std::uint32_t face : {0, 1}) {
    failed.constraint.second = {face};
    decaying.add(cubes.parts.context(0.1), failed);
  }
  decaying.end_changed(cubes.parts.rules);
  CHECK(decaying.constraints().size() == 2);
  ContactRemap remap;
  remap.faces = {FaceIndex{0}, std::nullopt};
  for (std::uint32_t node = 0; node < 16; ++node) remap.nodes.push_back(ContactNodeIndex{node});
  decaying.remap(remap);
  REQUIRE(decaying.constraints().size() == 1);
  CHECK(decaying.constraints()[0].second == FaceIndex{0});
}

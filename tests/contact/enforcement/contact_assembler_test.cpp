// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_assembler.hpp"

#include "contact/formulations/tied/ties.hpp"

#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;
using Eigen::Vector4d;

namespace {

/// A force of 10 along z at the middle of an edge of the first side and at a corner of the second.
ContactPoint sample_record() {
  ContactPoint point;
  point.pair = {1};
  point.first = {{0, 1, 2, 3}, Vector4d(0.5, 0.5, 0.0, 0.0)};
  point.second = {{4, 5, 6, 6}, Vector4d(1.0, 0.0, 0.0, 0.0)};
  point.normal = Vector3d::UnitZ();
  point.force = 10.0;
  point.tangential = Vector3d(3.0, 0.0, 0.0);
  point.elastic_slip = Vector3d(-0.2, 0.0, 0.0);
  point.gap = -0.5;
  point.stiffness = 20.0;
  point.area = 2.0;
  point.slip = Vector3d(-0.1, 0.0, 0.0);
  point.dissipated = 0.3;
  point.damped = 0.7;
  return point;
}

}  // namespace

TEST_CASE("a contact point pushes the corners of both sides by their shares",
          "[contact][contact_assembler]") {
  ContactAssembler sums(7, 2, false);
  sums.begin_step();
  sums.add(sample_record());
  CHECK(sums.nodes()[{0}] == Eigen::Vector4d(1.5, 0.0, 5.0, 10.0));
  CHECK(sums.nodes()[{1}] == sums.nodes()[{0}]);
  CHECK(sums.nodes()[{2}].norm() == 0.0);
  CHECK(sums.nodes()[{4}] == Eigen::Vector4d(-3.0, 0.0, -10.0, 20.0));
  sums.add(sample_record());
  CHECK(sums.nodes()[{4}] == Eigen::Vector4d(-6.0, 0.0, -20.0, 40.0));
  sums.begin_step();
  for (const NodeVector& node : sums.nodes()) CHECK(node.norm() == 0.0);
}

TEST_CASE("a pair gets the force on its first surface, area and energies", "[contact][contact_assembler]") {
  ContactAssembler sums(7, 2, false);
  sums.begin_step();
  sums.add(sample_record());
  const PairStep& pair = sums.pairs()[{1}];
  CHECK(pair.force == Vector3d(3.0, 0.0, 10.0));
  CHECK(pair.area == 2.0);
  CHECK(pair.stored == Approx(0.5 * (3.0 * 0.2 + 10.0 * 0.5)));
  CHECK(pair.dissipated == 0.3);
  CHECK(pair.damped == 0.7);
  CHECK((pair.touches && pair.is_near));
  CHECK(!sums.pairs()[{0}].touches);
  CHECK(sums.dissipated() == 0.3);
  CHECK(sums.damped() == 0.7);
  ContactPoint swapped = sample_record();
  swapped.is_swapped = true;
  sums.add(swapped);
  CHECK(sums.pairs()[{1}].force.norm() == 0.0);
  CHECK(sums.pairs()[{1}].area == 4.0);
  sums.begin_step();
  CHECK(sums.dissipated() == 0.0);
  CHECK(!sums.pairs()[{1}].touches);
}

TEST_CASE("a place that does not touch yet gives its stiffness only", "[contact][contact_assembler]") {
  ContactAssembler sums(7, 2, true);
  sums.begin_step();
  ContactPoint point = sample_record();
  point.force = 0.0;
  point.tangential.setZero();
  point.gap = 0.1;
  sums.add(point);
  sums.end_step();
  CHECK(sums.nodes()[{0}] == Eigen::Vector4d(0.0, 0.0, 0.0, 10.0));
  CHECK(sums.pairs()[{1}].is_near);
  CHECK(!sums.pairs()[{1}].touches);
  CHECK(sums.pairs()[{1}].area == 0.0);
  CHECK(sums.friction()[{0}].slip_length == 0.0);
}

TEST_CASE("slips of nodes are means by area, added up as vectors and by length",
          "[contact][contact_assembler]") {
  ContactAssembler sums(7, 2, true);
  ContactPoint other = sample_record();
  other.area = 6.0;
  other.slip = Vector3d(0.3, 0.4, 0.0);
  other.dissipated = 0.1;
  sums.begin_step();
  sums.add(sample_record());
  sums.add(other);
  sums.end_step();
  const Vector3d mean = (2.0 * Vector3d(-0.1, 0, 0) + 6.0 * Vector3d(0.3, 0.4, 0)) / 8.0;
  CHECK((sums.friction()[{0}].last_slip - mean).norm() < 1e-15);
  CHECK((sums.friction()[{4}].last_slip + mean).norm() < 1e-15);
  CHECK(sums.friction()[{2}].slip_length == 0.0);
  // Half of what is lost is each side's.
  CHECK(sums.friction()[{0}].energy == Approx(0.25 * 0.4));
  CHECK(sums.friction()[{4}].energy == Approx(0.5 * 0.4));
  sums.begin_step();
  ContactPoint back = sample_record();
  back.slip = -mean;
  sums.add(back);
  sums.end_step();
  CHECK(sums.friction()[{0}].slip.norm() < 1e-15);
  CHECK(sums.friction()[{0}].slip_length == Approx(2.0 * mean.norm()));
  sums.begin_step();
  sums.end_step();
  CHECK(sums.friction()[{0}].last_slip.norm() == 0.0);
  CHECK(sums.friction()[{0}].slip_length == Approx(2.0 * mean.norm()));
  CHECK(ContactAssembler(7, 2, false).friction().empty());
}

TEST_CASE("a tie gives its forces, its springs and what they hold", "[contact][contact_assembler]") {
  ContactAssembler sums(9, 2, false);
  Tie tie;
  tie.pair = {1};
  tie.nodes = {0, 1, 2, 3, 4, 5, 6, 7};
  tie.area = 3.0;
  for (int k = 0; k < 8; ++k) tie.springs[k] = 1.0 + k;
  CornerForces forces;
  forces.forces.setZero();
  forces.forces.leftCols<4>().row(1).setConstant(2.0);
  forces.forces.rightCols<4>().row(1).setConstant(-2.0);
  forces.stored = 0.25;
  sums.begin_step();
  sums.add(tie, forces);
  CHECK(sums.nodes()[{3}] == Eigen::Vector4d(0.0, 2.0, 0.0, 4.0));
  CHECK(sums.nodes()[{7}] == Eigen::Vector4d(0.0, -2.0, 0.0, 8.0));
  CHECK(sums.pairs()[{1}].force == Vector3d(0.0, 8.0, 0.0));
  CHECK(sums.pairs()[{1}].area == 3.0);
  CHECK(sums.pairs()[{1}].stored == 0.25);
  CHECK(sums.pairs()[{1}].touches);
  tie.is_swapped = true;
  sums.add(tie, forces);
  CHECK(sums.pairs()[{1}].force.norm() == 0.0);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/static_problem.hpp"
#include "support/capped_cube.hpp"
#include "support/catch.hpp"
#include "support/trial_contact.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

const Eigen::Matrix3d slanted_spring = (Eigen::Matrix3d() << 4, 1, 0, 1, 3, -1, 0, -1, 5).finished() * 1e11;

/// The problem of a cube with springs; node 0 is held.
struct SprungCube {
  SprungCube() : cube({NodeIndex{0}}), contact(cube.mesh.coordinates()) {
    problem.emplace(cube.model, ForceTerms{*cube.internal, cube.nothing, &contact}, &contact,
                    ResidualReference::internal, cube.state);
    problem->begin_step(1.0);
  }
  Eigen::VectorXd product(const Eigen::VectorXd& direction) {
    problem->find_springs();
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(direction.size());
    problem->add_springs(direction, sum);
    return sum;
  }

  StaticCube cube;
  TrialContact contact;
  std::optional<StaticProblem> problem;
};

}  // namespace

TEST_CASE("springs push both ends alike, held ones neither feel nor do anything", "[core][statics]") {
  SprungCube sprung;
  sprung.contact.springs = {spring_between(4, 26, slanted_spring), spring_between(0, 13, slanted_spring)};
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(81);
  direction.segment<3>(0) << 9, 9, 9;  // of the held node
  direction.segment<3>(12) << 1, 2, 3;
  direction.segment<3>(39) << 0, 1, 0;
  const Eigen::VectorXd product = sprung.product(direction);
  const Eigen::Vector3d between = slanted_spring * Eigen::Vector3d(1, 2, 3);
  CHECK(product.segment<3>(12).isApprox(between, 1e-14));
  CHECK(product.segment<3>(3 * 26).isApprox(-between, 1e-14));
  CHECK(product.segment<3>(39).isApprox(slanted_spring.col(1), 1e-14));
  CHECK(product.segment<3>(0).isZero(0.0));
  CHECK(sprung.problem->springs().size() == 2);
  sprung.contact.springs.clear();
  CHECK(sprung.product(direction).isZero(0.0));
}

TEST_CASE("a product is added to what is there", "[core][statics]") {
  SprungCube sprung;
  sprung.contact.springs = {spring_between(4, 26, slanted_spring)};
  sprung.problem->find_springs();
  const Eigen::VectorXd direction = Eigen::ArrayXd::LinSpaced(81, 0.0, 9.0).sin();
  Eigen::VectorXd once = Eigen::VectorXd::Zero(81);
  sprung.problem->add_springs(direction, once);
  Eigen::VectorXd twice = once;
  sprung.problem->add_springs(direction, twice);
  CHECK(twice.isApprox(2.0 * once, 1e-14));
}

TEST_CASE("springs on nodes of a rigid body are those of its two nodes", "[core][statics]") {
  CappedCube cube;
  TrialContact contact(cube.mesh.coordinates());
  // Between two nodes of the cap, one of the cap and one inside, and two of the mesh alone.
  contact.springs = {spring_between(20, 26, slanted_spring), spring_between(18, 13, slanted_spring),
                     spring_between(9, 17, slanted_spring)};
  StaticProblem with(cube.model, ForceTerms{*cube.internal, cube.load, &contact}, &contact,
                     ResidualReference::internal, cube.state);
  with.begin_step(1.0);
  Eigen::VectorXd direction = Eigen::ArrayXd::LinSpaced(with.size(), 0.0, 40.0).sin(), sum = 0.0 * direction;
  for (const NodeIndex node : cube.model.rigid.bodies[0].nodes)
    direction.segment<3>(3 * Eigen::Index{node.value}).setZero();
  with.project(direction);
  with.find_springs();
  with.add_springs(direction, sum);
  for (const ContactSpring& spring : with.springs()) {
    for (const SpringEnd& end : spring.ends) CHECK_FALSE(with.bodies().moves(end.node));
  }
  // By differences of residuals with and without the springs; without forces nothing else depends on turns.
  constexpr double h = 1e-6;
  const auto change = [&](StaticProblem& problem) -> Eigen::VectorXd {
    Eigen::VectorXd before, after;
    REQUIRE(problem.evaluate(-h * direction, before));
    REQUIRE(problem.evaluate(h * direction, after));
    return (before - after) / (2.0 * h);
  };
  const Eigen::VectorXd all = change(with);
  contact.springs.clear();
  const Eigen::VectorXd expected = all - change(with);
  Eigen::VectorXd found = sum;
  with.project(found);
  CHECK(expected.segment<6>(cube.centre()).norm() > 1e10);
  CHECK((found - expected).norm() < 1e-5 * all.norm());
}

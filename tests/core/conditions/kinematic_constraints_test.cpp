// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/kinematic_constraints.hpp"

#include <omp.h>

#include <cmath>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/condition_deck.hpp"
#include "support/constrained_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Nodes of mass 1 that are pushed by constant forces, moved by central differences as the integrator does
/// it, under the kinematic conditions of a region's lines.
struct Run {
  explicit Run(const std::string& lines)
      : mesh(constrained_cube()),
        deck(mesh, lines),
        kinematic_constraints(make_kinematic_constraints(deck.scope())) {
    if (!deck.messages().empty()) throw std::logic_error(deck.messages());
    force = Eigen::Matrix3Xd::Constant(3, 8, 0.0);
    x = mesh.coordinates();
    v = Eigen::Matrix3Xd::Zero(3, 8);
  }

  /// Steps of dt, 3/2 dt, dt, ...
  void advance(int n_steps, double dt) {
    double before = 0.0, after = dt;
    kinematic_constraints.constrain_velocity({time, 0.0, after, x, v}, v);
    for (int i = 0; i < n_steps; ++i) {
      Eigen::Matrix3Xd a = force;
      kinematic_constraints.constrain({time, before, after, x, v}, a);
      v += 0.5 * (before + after) * a;
      x += after * v;
      time += after;
      before = after;
      after = i % 2 == 0 ? 1.5 * dt : dt;
    }
  }

  Eigen::Vector3d u(int node) const { return x.col(node - 1) - mesh.coordinates().col(node - 1); }

  Mesh mesh;
  ConditionDeck deck;
  KinematicConstraints kinematic_constraints;
  Eigen::Matrix3Xd force, x, v;  ///< v at the middle of the last step
  double time = 0.0;
};

}  // namespace

TEST_CASE("a held node stays in place to the last bit, its free components move", "[core][conditions]") {
  Run run(condition_block("fixed displacement", "node set = n1 n2\ncomponents = x z"));
  run.force.setConstant(0.3);
  run.v.setConstant(7.0);
  run.advance(50, 1e-3);
  CHECK(run.x(0, 0) == 1.0);
  CHECK(run.x(2, 1) == 1.0);
  CHECK(run.u(1).y() == Approx(7.0 * run.time + 0.15 * run.time * run.time).epsilon(1e-2));
  CHECK(run.u(3).x() == Approx(run.u(1).y()));
  CHECK(run.kinematic_constraints.nodes().size() == 2);
}

TEST_CASE("a prescribed displacement is reached at every step", "[core][conditions]") {
  Run run(condition_block("prescribed displacement",
                          "block = block_1\ncomponent = y\nfunction = ramp\nscale factor = 3"));
  run.advance(7, 0.1);
  CHECK(run.u(5).y() == Approx(3.0 * run.time).epsilon(1e-14));
  CHECK(run.u(5).x() == 0.0);
}

TEST_CASE("a node starts at its prescribed speed, without a jump", "[core][conditions]") {
  Run run(condition_block("prescribed displacement",
                          "node set = n1\ncomponent = y\nfunction = ramp\nscale factor = 3") +
          condition_block("prescribed velocity",
                          "node set = n2\ndirection = slanted\nfunction = one\nscale factor = 5") +
          condition_block("prescribed acceleration", "node set = n3\ncomponent = z\nfunction = one") +
          condition_block("fixed displacement", "node set = n4\ncomponent = z") +
          condition_block("prescribed velocity", "node set = n5\ncylindrical axis = spin\nfunction = one"));
  run.v.setConstant(1.0);
  run.kinematic_constraints.constrain_velocity({0.0, 0.0, 0.25, run.x, run.v}, run.v);
  CHECK(run.v.col(0).isApprox(Eigen::Vector3d(1, 3, 1)));
  CHECK(run.v.col(1).isApprox(Eigen::Vector3d(1 + 3.6 * 0.6, 1 + 3.6 * 0.8, 1)));  // 5 - 1.4 along (3 4 0)/5
  CHECK(run.v.col(2).isApprox(Eigen::Vector3d(1, 1, 1)));
  CHECK(run.v.col(3) == Eigen::Vector3d(1, 1, 0));
  CHECK(run.v.col(4).isApprox(Eigen::Vector3d(-1, 1, 1)));  // at (1 1 2), about z
}

TEST_CASE("a velocity is that of the middle of the step, an acceleration that of now", "[core][conditions]") {
  Run run(condition_block("prescribed velocity",
                          "node set = n1\ncomponent = x\nfunction = ramp\nscale factor = 2") +
          condition_block("prescribed acceleration", "node set = n2\ncomponent = x\nfunction = ramp"));
  run.advance(1, 0.5);
  CHECK(run.v(0, 0) == Approx(0.5).epsilon(1e-14));
  CHECK(run.v(0, 1) == 0.0);
  Eigen::Matrix3Xd a = run.force;
  run.kinematic_constraints.constrain({0.5, 0.5, 1.0, run.x, run.v}, a);
  CHECK(a(0, 0) == Approx((2.0 - 0.5) / 0.75).epsilon(1e-14));  // to 2 x 1.0 at the middle of the step
  CHECK(a(0, 1) == 0.5);
  CHECK(a(1, 1) == 0.0);
}

TEST_CASE("along a direction the plane at right angles to it stays free", "[core][conditions]") {
  Run run(condition_block("prescribed displacement", "node set = n1\ndirection = slanted\nfunction = one") +
          condition_block("fixed displacement", "node set = n1\ndirection = across"));
  run.force.setConstant(2.0);
  run.advance(4, 0.1);
  CHECK(run.u(1).x() == Approx(0.6).epsilon(1e-13));
  CHECK(run.u(1).y() == Approx(0.8).epsilon(1e-13));
  CHECK(run.u(1).z() == Approx(run.u(2).z()).epsilon(1e-14));
}

TEST_CASE("about an axis nodes move on exact arcs", "[core][conditions]") {
  Run run(
      condition_block("prescribed velocity",
                      "node set = n1\ncylindrical axis = spin\nfunction = one\nscale factor 2") +
      condition_block("prescribed displacement", "node set = n2\ncylindrical axis = spin\nfunction = ramp") +
      condition_block("prescribed acceleration", "node set = n3\ncylindrical axis = spin\nfunction = one") +
      condition_block("fixed displacement", "node set = n1 n2\ncomponent = z"));
  run.force.setConstant(0.5);
  run.v.row(2).setConstant(1.0);
  run.advance(40, 0.05);
  const auto angle = [&](int node) { return std::atan2(run.x(1, node - 1), run.x(0, node - 1)); };
  const auto radius = [&](int node) { return run.x.col(node - 1).head<2>().norm(); };
  CHECK(radius(1) == Approx(std::sqrt(2.0)).epsilon(1e-13));
  CHECK(radius(2) == Approx(std::sqrt(5.0)).epsilon(1e-13));
  CHECK(radius(3) == Approx(std::sqrt(5.0)).epsilon(1e-12));
  const double turn = std::remainder(2 * run.time - (angle(1) - std::atan2(1.0, 1.0)), 2 * std::acos(-1.0));
  CHECK(turn == Approx(0.0).margin(1e-12));
  CHECK(angle(2) == Approx(run.time + std::atan2(1.0, 2.0)).epsilon(1e-12));
  CHECK(run.x(2, 0) == 1.0);
  CHECK(run.u(3).z() == Approx(run.u(4).z()).epsilon(1e-13));  // free along the axis
}

TEST_CASE("an angular acceleration turns a node as it moves a free one on a line", "[core][conditions]") {
  Run run(
      condition_block("prescribed acceleration", "node set = n3\ncylindrical axis = spin\nfunction = one"));
  run.force.row(0).setConstant(1.0);
  run.advance(20, 0.02);
  const double angle = std::atan2(run.x(1, 2), run.x(0, 2)) - std::atan2(2.0, 1.0);
  CHECK(angle == Approx(run.u(4).x()).epsilon(1e-12));
}

TEST_CASE("conditions act in their periods and let go after them", "[core][conditions]") {
  Run run(
      condition_block("prescribed velocity",
                      "node set = n1\ncomponent = x\nfunction = one\nactive periods = p2") +
      condition_block("prescribed velocity",
                      "node set = n1\ncomponent = x\nfunction = one\nscale factor = 4\nactive periods = p3") +
      condition_block("fixed displacement", "node set = n1\ncomponent = x\nactive periods = p1"));
  run.v.setConstant(2.0);
  run.advance(8, 0.1);
  CHECK(run.time == Approx(1.0));
  CHECK(run.u(1).x() == 0.0);
  run.time = 1.0;
  run.kinematic_constraints.constrain_velocity({1.0, 0.0, 0.25, run.x, run.v}, run.v);
  CHECK(run.v(0, 0) == 1.0);
  run.kinematic_constraints.constrain_velocity({2.0, 0.0, 0.25, run.x, run.v}, run.v);
  CHECK(run.v(0, 0) == 4.0);
}

TEST_CASE("nodes may be held twice, in slanted directions too", "[core][conditions]") {
  Run run(condition_block("fixed displacement", "node set = n1 n2\ncomponent = x") +
          condition_block("fixed displacement", "node set = n1 n3\ndirection = slanted") +
          condition_block("fixed displacement", "node set = n1\ncomponents = x z"));
  run.force.setConstant(1.0);
  run.v.setConstant(3.0);
  run.advance(10, 0.1);
  CHECK(run.u(1) == Eigen::Vector3d(0, 0, 0));
  CHECK(run.u(2).x() == 0.0);
  CHECK(run.u(2).y() == run.u(4).y());
  CHECK(run.u(3).dot(Eigen::Vector3d(0.6, 0.8, 0)) == Approx(0.0).margin(1e-14));
  CHECK(run.u(3).dot(Eigen::Vector3d(-0.8, 0.6, 0)) != Approx(0.0).margin(1e-3));
}

TEST_CASE("a value may vary from node to node", "[core][conditions]") {
  Run run(condition_block("prescribed velocity",
                          "block = block_1\ncomponent = z\nfunction = at_x\nscale factor = 0.5"));
  run.advance(3, 0.1);
  CHECK(run.v(2, 0) == Approx(1.0));
  CHECK(run.v(2, 1) == Approx(2.0));
}

TEST_CASE("a value that is not finite ends the run at the condition", "[core][conditions]") {
  const auto failure = [](const std::string& function) {
    Run run(condition_block("prescribed velocity", "block = block_1\ncomponent = z\nfunction = " + function));
    Eigen::Matrix3Xd a = run.force;
    try {
      run.kinematic_constraints.constrain({0.5, 0.0, 1.0, run.x, run.v}, a);
    } catch (const SolveError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(failure("bad") == "time 1: the function of the prescribed velocity at c.i:1:1 has no finite value");
  CHECK(failure("bad_at_x") ==
        "time 1: the function of the prescribed velocity at c.i:1:1 has no finite value at node 1");
  CHECK(failure("one") == "");
}

TEST_CASE("constraints are the same bits for any number of threads", "[core][conditions]") {
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1, .cells = {40, 30, 20}}).build();
  ConditionDeck deck(mesh, condition_block("prescribed velocity",
                                           "block = block_1\ncylindrical axis = spin\nfunction = at_x"));
  const KinematicConstraints kinematic_constraints = make_kinematic_constraints(deck.scope());
  const Eigen::Matrix3Xd v = mesh.coordinates().array().sin().matrix();
  const int n_threads = omp_get_max_threads();
  std::vector<Eigen::Matrix3Xd> found;
  for (const int n : {1, 2, 3}) {
    omp_set_num_threads(n);
    found.push_back(mesh.coordinates());
    kinematic_constraints.constrain({0.5, 0.1, 0.2, mesh.coordinates(), v}, found.back());
  }
  omp_set_num_threads(n_threads);
  CHECK(found[0] == found[1]);
  CHECK(found[0] == found[2]);
  CHECK(found[0] != mesh.coordinates());
}

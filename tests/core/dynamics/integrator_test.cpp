// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/integrator.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "core/base/errors.hpp"
#include "core/dynamics/internal_force.hpp"
#include "core/elements/element_table.hpp"
#include "core/materials/elastic.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;

namespace {

/// Every node pulled home by a spring of its own.
class Springs final : public ForceTerm {
 public:
  ///   variation  of the stable step with the stretch
  Springs(const Eigen::Matrix3Xd& home, double stiffness, double variation = 0.0)
      : home_(home), stiffness_(stiffness), variation_(variation) {}
  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override {
    forces = stiffness_ * (home_ - motion.coordinates);
    return {1.0 + variation_ * (motion.coordinates(0, 0) - home_(0, 0)), std::nullopt, 0.0, 0.0};
  }

 private:
  Eigen::Matrix3Xd home_;
  double stiffness_, variation_;
};

/// The same force on every node.
class Push final : public ForceTerm {
 public:
  explicit Push(const Eigen::Vector3d& force) : force_(force) {}
  ForceReport set_forces(const Motion&, Eigen::Matrix3Xd& forces) override {
    forces.colwise() = force_;
    return {};
  }

 private:
  Eigen::Vector3d force_;
};

/// A stable step that is smaller for a while.
class Hit final : public ForceTerm {
 public:
  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override {
    forces.setZero();
    ForceReport report;
    report.stable_step = motion.time > 20.0 && motion.time < 22.0 ? 0.5 : 1.0;
    return report;
  }
};

/// No force, and a stable step.
class Limit final : public ForceTerm {
 public:
  explicit Limit(double step, std::optional<ElementIndex> by = {}) : stable_step(step), element_(by) {}
  ForceReport set_forces(const Motion&, Eigen::Matrix3Xd& forces) override {
    forces.setZero();
    return {stable_step, element_, 0.0, 0.0};
  }
  double stable_step;

 private:
  std::optional<ElementIndex> element_;
};

TimeStepControl fixed_step(double dt) {
  TimePeriod period{"all", 0.0, {}};
  period.parameters.user_time_step = dt;
  return {{period}, 1e9};
}

/// A cube of eight nodes of mass 2 without elements.
struct Cube {
  Mesh mesh = test::MeshBuilder().add_hexes({}).build();
  Model model;
  State state = make_state(mesh.coordinates(), {}, 0.0);

  Cube() {
    model.mesh = &mesh;
    model.mass = Eigen::RowVectorXd::Constant(mesh.n_nodes(), 2.0);
  }
};

}  // namespace

TEST_CASE("central differences give a spring the frequency that theory says they do", "[core][integrator]") {
  Cube cube;
  Springs springs(cube.mesh.coordinates(), 2.0);  // omega = 1
  Push nothing(Eigen::Vector3d::Zero());
  cube.state.velocity.row(0).setOnes();
  constexpr double dt = 0.5;
  const TimeStepControl control = fixed_step(dt);
  start(cube.model, {springs, nothing}, control, cube.state);
  // sin(omega' dt / 2) = omega dt / 2; Belytschko (2014), eq. 6.2.30.
  const double omega = 2.0 / dt * std::asin(dt / 2.0);
  const double amplitude = dt / std::sin(omega * dt);
  for (int step = 1; step <= 40; ++step) {
    advance(cube.model, {springs, nothing}, control, cube.state);
    const double u = cube.state.coordinates(0, 3) - cube.mesh.coordinates()(0, 3);
    CHECK(u == Approx(amplitude * std::sin(omega * dt * step)).margin(1e-12));
  }
  CHECK(cube.state.time == Approx(20.0));
  CHECK(cube.state.step == 40);
}

TEST_CASE("the energy sum that central differences conserve stays where it is", "[core][integrator]") {
  Cube cube;
  Springs springs(cube.mesh.coordinates(), 2.0);
  Push push(Eigen::Vector3d(0.3, 0.0, -1.0));
  cube.state.velocity.row(1).setConstant(2.0);
  const TimeStepControl control = fixed_step(1.5);  // not far from the stable 2
  start(cube.model, {springs, push}, control, cube.state);
  for (int step = 0; step < 200; ++step) advance(cube.model, {springs, push}, control, cube.state);
  const Energies& e = cube.state.energies;
  CHECK(e.largest > 1.0);
  CHECK(std::abs(e.error) < 1e-11 * e.largest);  // 200 sums of some 10 terms: 2000 round-offs
  CHECK(e.kinetic == Approx(0.5 * 2.0 * cube.state.velocity.squaredNorm()));
  CHECK((cube.state.momentum - 2.0 * cube.state.velocity.rowwise().sum()).norm() < 1e-12 * 100);
}

TEST_CASE("a spring that shortens the steps when it is stretched does not grow by it", "[core][integrator]") {
  Cube cube;
  Springs springs(cube.mesh.coordinates(), 2.0, 0.02);
  Push nothing(Eigen::Vector3d::Zero());
  cube.state.velocity.row(0).setOnes();
  const TimeStepControl control({{"all", 0.0, {}}}, 1e9);
  start(cube.model, {springs, nothing}, control, cube.state);
  for (int step = 0; step < 20000; ++step) advance(cube.model, {springs, nothing}, control, cube.state);
  const Energies& e = cube.state.energies;
  CHECK(e.kinetic + e.internal == Approx(8.0).epsilon(0.01));  // each new least step leaves a trace
  CHECK(e.internal >= 0.0);
}

TEST_CASE("a step that contact makes vanish is not blamed on an element", "[core][integrator]") {
  Cube cube;
  Limit element(1.0, ElementIndex{0}), stiff(1.0);
  Push nothing(Eigen::Vector3d::Zero());
  cube.state.forces.contact = Eigen::Matrix3Xd::Zero(3, cube.mesh.n_nodes());
  const TimeStepControl control({{"all", 0.0, {}}}, 1e9);
  start(cube.model, {element, nothing, &stiff}, control, cube.state);
  SECTION("elements' own") {
    element.stable_step = 1e-9;
    CHECK_THROWS_WITH(advance(cube.model, {element, nothing, &stiff}, control, cube.state),
                      Catch::Matchers::Contains("set by element 1"));
  }
  SECTION("contact's") {
    stiff.stable_step = 1e-9;
    CHECK_THROWS_WITH(advance(cube.model, {element, nothing, &stiff}, control, cube.state),
                      Catch::Matchers::Contains("set by the stiffness of contact"));
  }
}

TEST_CASE("the stable step falls at once and comes back by half a percent per step", "[core][integrator]") {
  Cube cube;
  Hit hit;
  Push nothing(Eigen::Vector3d::Zero());
  TimePeriod period{"all", 0.0, {}};
  period.parameters.time_step_scale_factor = 1.0;
  const TimeStepControl control({period}, 1e9);
  start(cube.model, {hit, nothing}, control, cube.state);
  double last = cube.state.next_dt, least = last;
  for (int step = 0; step < 600; ++step) {
    advance(cube.model, {hit, nothing}, control, cube.state);
    CHECK(cube.state.next_dt <= 1.00501 * last);
    last = cube.state.next_dt;
    least = std::min(least, last);
    if (step == 100) CHECK(last == 0.5);  // held through vibrations first
  }
  CHECK(least == 0.5);
  CHECK(last == 1.0);
}

TEST_CASE("a free fall follows its parabola, and gravity's work becomes kinetic energy",
          "[core][integrator]") {
  Cube cube;
  Springs none(cube.mesh.coordinates(), 0.0);
  Push weight(Eigen::Vector3d(0.0, 0.0, -2.0 * 9.81));
  const TimeStepControl control = fixed_step(0.1);
  start(cube.model, {none, weight}, control, cube.state);
  for (int step = 0; step < 10; ++step) advance(cube.model, {none, weight}, control, cube.state);
  CHECK(cube.state.coordinates(2, 0) - cube.mesh.coordinates()(2, 0) == Approx(-0.5 * 9.81));
  CHECK(cube.state.velocity(2, 0) == Approx(-9.81));
  CHECK(cube.state.energies.external == Approx(8 * 2.0 * 9.81 * 0.5 * 9.81));
  CHECK(cube.state.energies.kinetic == Approx(cube.state.energies.external));
}

TEST_CASE("a node without mass that is pushed stops the run with its id", "[core][integrator]") {
  Cube cube;
  cube.model.mass.col(5).setConstant(minimum_nodal_mass);
  Springs none(cube.mesh.coordinates(), 0.0);
  Push push(Eigen::Vector3d::UnitX());
  CHECK_THROWS_WITH(start(cube.model, {none, push}, fixed_step(0.1), cube.state),
                    Catch::Contains("node 6 has no mass but is pushed"));
}

TEST_CASE("a run of elements gives the same bits with one thread and with two", "[core][integrator]") {
  const Mesh mesh = test::MeshBuilder().add_hexes({1, "", {12, 12, 12}}).build();
  const auto run = [&](int threads) {
    omp_set_num_threads(threads);
    Model model;
    model.mesh = &mesh;
    model.blocks.push_back(make_solid_block(mesh, 0, *find_solid_element(Shape::hex8, "mean_quadrature"),
                                            {ElasticLaw{{160e9, 80e9}}, 7800.0}));
    model.mass = lumped_mass(mesh, model.blocks);
    State state = make_state(mesh.coordinates(), model.blocks, 0.0);
    for (Eigen::Index i = 0; i < state.velocity.cols(); ++i)
      state.velocity(0, i) = 10.0 * std::sin(static_cast<double>(i));
    InternalForce internal(model, state);
    Push nothing(Eigen::Vector3d::Zero());
    TimePeriod period{"all", 0.0, {}};
    const TimeStepControl control({period}, 1e9);
    start(model, {internal, nothing}, control, state);
    for (int step = 0; step < 20; ++step) advance(model, {internal, nothing}, control, state);
    return state;
  };
  const State one = run(1), two = run(2);
  CHECK(one.time == two.time);
  CHECK((one.coordinates.array() == two.coordinates.array()).all());
  CHECK((one.velocity.array() == two.velocity.array()).all());
  CHECK(one.energies.internal == two.energies.internal);
  CHECK(one.energies.error == two.energies.error);
  CHECK(std::abs(one.energies.error) < 1e-3 * one.energies.largest);  // steps grow at the start
}

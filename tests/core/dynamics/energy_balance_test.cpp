// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/energy_balance.hpp"

#include <omp.h>

#include <random>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

Eigen::Matrix3Xd random_vectors(Eigen::Index n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  return Eigen::Matrix3Xd::NullaryExpr(3, n, [&](Eigen::Index, Eigen::Index) { return number(random); });
}

/// A mesh of n nodes without elements.
Mesh nodes_only(Eigen::Index n) {
  MeshParts parts;
  parts.coordinates = Eigen::Matrix3Xd::Zero(3, n);
  return Mesh(std::move(parts));
}

struct Nodes {
  Mesh mesh;
  Model model;
  State state;

  explicit Nodes(Eigen::Index n) : mesh(nodes_only(n)) {
    model.mesh = &mesh;
    model.mass = random_vectors(n, 1).row(0).array() + 2.0;
    state = make_state(mesh.coordinates(), {}, 0.0);
    state.velocity = random_vectors(n, 2);
    state.acceleration = random_vectors(n, 3);
    state.forces = {random_vectors(n, 4), random_vectors(n, 5), random_vectors(n, 6)};
    state.dt = 0.25;
    state.next_dt = 0.5;
  }
  Nodes(const Nodes&) = delete;
  Nodes& operator=(const Nodes&) = delete;
};

}  // namespace

TEST_CASE("velocities are brought to now, and work and energy are sums over the nodes",
          "[core][energy_balance]") {
  for (const Eigen::Index n : {1, 7, 8, 2500}) {  // below, across and beyond a group of eight and a chunk
    Nodes nodes(n);
    const Eigen::Matrix3Xd before = nodes.state.velocity, a = nodes.state.acceleration;
    const Eigen::Matrix3Xd now = before + 0.125 * a, after = now + 0.25 * a;
    const Eigen::Matrix3Xd mass = nodes.model.mass.replicate<3, 1>();
    const EnergyBalance balance = complete_velocities(nodes.model, nodes.state);
    CHECK(nodes.state.velocity == now);
    CHECK(balance.kinetic == Approx(0.5 * mass.cwiseProduct(now).cwiseProduct(now).sum()));
    CHECK(balance.conserved == Approx(0.5 * mass.cwiseProduct(after).cwiseProduct(before).sum()));
    // Internal forces act on all; 0.5 half steps^2 mass acceleration^2.
    CHECK(balance.unseen == Approx(0.5 * 0.125 * 0.25 * mass.cwiseProduct(a).cwiseProduct(a).sum()));
    CHECK((balance.momentum - mass.cwiseProduct(now).rowwise().sum()).norm() <
          1e-10 * static_cast<double>(n));
    const NodalForces& forces = nodes.state.forces;
    const double margin = 1e-12 * static_cast<double>(n);  // round-off of n terms below 1
    CHECK(balance.ended.internal ==
          Approx(0.125 * forces.internal.cwiseProduct(before).sum()).margin(margin));
    CHECK(balance.begun.internal == Approx(0.25 * forces.internal.cwiseProduct(after).sum()).margin(margin));
    CHECK(balance.ended.external ==
          Approx(0.125 * forces.external.cwiseProduct(before).sum()).margin(margin));
    CHECK(balance.begun.external == Approx(0.25 * forces.external.cwiseProduct(after).sum()).margin(margin));
    CHECK(balance.ended.contact == Approx(0.125 * forces.contact.cwiseProduct(before).sum()).margin(margin));
    CHECK(balance.begun.contact == Approx(0.25 * forces.contact.cwiseProduct(after).sum()).margin(margin));
  }
}

TEST_CASE("at the start the conserved energy is that of a step mirrored in time", "[core][energy_balance]") {
  Nodes nodes(9);
  nodes.state.dt = 0.0;
  const Eigen::Matrix3Xd now = nodes.state.velocity, a = nodes.state.acceleration;
  const EnergyBalance balance = complete_velocities(nodes.model, nodes.state);
  CHECK(nodes.state.velocity == now);
  const Eigen::Matrix3Xd after = now + 0.25 * a, behind = now - 0.25 * a;
  CHECK(balance.conserved ==
        Approx(0.5 * nodes.model.mass.replicate<3, 1>().cwiseProduct(after).cwiseProduct(behind).sum()));
}

TEST_CASE("a run without loads has the energies and reactions of loads of 0", "[core][energy_balance]") {
  Nodes zero(9), none(9);
  zero.state.forces.external.setZero();
  none.state.forces.external.resize(3, 0);
  CHECK(reaction_at(none.model, none.state, {1}) == reaction_at(zero.model, zero.state, {1}));
  const EnergyBalance with = complete_velocities(zero.model, zero.state),
                      without = complete_velocities(none.model, none.state);
  CHECK(none.state.velocity == zero.state.velocity);
  CHECK(without.kinetic == with.kinetic);
  CHECK(without.conserved == with.conserved);
  CHECK(without.begun.internal == with.begun.internal);
  CHECK(without.begun.contact == with.begun.contact);
  CHECK(without.ended.external == 0.0);
  CHECK(without.begun.external == 0.0);
}

TEST_CASE("the reaction is what mass times acceleration has beyond the forces", "[core][energy_balance]") {
  Nodes nodes(3);
  const State& state = nodes.state;
  const Eigen::Vector3d expected = nodes.model.mass(1) * state.acceleration.col(1) -
                                   state.forces.internal.col(1) - state.forces.external.col(1) -
                                   state.forces.contact.col(1);
  CHECK((reaction_at(nodes.model, state, {1}) - expected).norm() < 1e-15);
}

TEST_CASE("work and energy have the same bits for any number of threads", "[core][energy_balance]") {
  const int n_threads = omp_get_max_threads();
  omp_set_num_threads(1);
  Nodes alone(50000);
  const EnergyBalance one = complete_velocities(alone.model, alone.state);
  omp_set_num_threads(3);
  Nodes many(50000);
  const EnergyBalance three = complete_velocities(many.model, many.state);
  omp_set_num_threads(n_threads);
  CHECK(one.kinetic == three.kinetic);
  CHECK(one.conserved == three.conserved);
  CHECK(one.momentum == three.momentum);
  CHECK(one.ended.internal == three.ended.internal);
  CHECK(one.begun.external == three.begun.external);
  CHECK(alone.state.velocity == many.state.velocity);
}

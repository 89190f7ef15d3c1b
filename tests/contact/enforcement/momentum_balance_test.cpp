// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/momentum_balance.hpp"

#include <omp.h>

#include "core/dynamics/state.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/law_bodies.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace momentum_balance_test {

namespace {

/// Two free blocks of unlike meshes, one above the other, that close by their velocities in the coming step.
struct ClosingBlocks {
  explicit ClosingBlocks(const std::string& more, double gap = 0.01, int cells = 3)
      : ClosingBlocks(blocks(gap, cells), more) {}
  ClosingBlocks(const MeshBuilder& mesh, const std::string& more)
      : bodies(mesh, general_contact("enforcement = momentum_balance\n" + more)) {
    bodies.ask();
    state = make_state(bodies.x, bodies.model.blocks, 0.0);
    state.dt = state.next_dt = step;
    state.velocity = Eigen::Matrix3Xd::Zero(3, bodies.x.cols());
    state.acceleration = Eigen::Matrix3Xd::Zero(3, bodies.x.cols());
  }

  static MeshBuilder blocks(double gap, int cells) {
    MeshBuilder b;
    b.add_hexes({.id = 1, .cells = {2, 2, 1}});
    b.add_hexes({.id = 2, .cells = {cells, cells, 1}, .origin = {0, 0, 1 + gap}, .share_nodes = false});
    return b;
  }

  /// Throws the upper block; the forces of the balance.
  Eigen::Matrix3Xd forces_at(const Eigen::Vector3d& velocity) {
    bodies.set_velocity(1, velocity);
    state.velocity = bodies.v;
    state.coordinates = bodies.x;
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, bodies.x.cols());
    bodies.contact.set_forces(bodies.motion(), forces);
    CHECK(forces.isZero(0.0));
    report = bodies.contact.balance(state, forces);
    return forces;
  }

  /// Velocities after the forces have acted over the step.
  Eigen::Matrix3Xd velocity_after(const Eigen::Matrix3Xd& forces) const {
    return state.velocity + step * forces.cwiseQuotient(bodies.model.mass.replicate<3, 1>());
  }

  static constexpr double step = 0.1;
  ContactBodies bodies;
  State state;
  std::optional<ForceReport> report;
};

const std::string node_face = "constraint formulation = node_face\n";
const std::string rough =
    "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 0.2\n";

}  // namespace

TEST_CASE("a node that is tied and whose faces lie beside the other side has forces all the same",
          "[contact][enforcement]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {8, 8, 1}});
  b.add_hexes({.id = 2, .origin = {0.6, 0.95, 1.0}, .share_nodes = false});
  ClosingBlocks blocks(b, node_face + "friction model = tied\n");
  const Eigen::Matrix3Xd at_rest = blocks.forces_at({0, 0, 0});
  CHECK(at_rest.allFinite());
  const Eigen::Matrix3Xd pulled = blocks.forces_at({0, 0, 1});
  CHECK(at_rest.norm() < 1e-12 * pulled.norm());  // round-off
  CHECK(pulled.allFinite());
  CHECK(pulled.row(2).tail(8).sum() < 0.0);
}

TEST_CASE("momentum balance closes the gap and no more, alike on both sides", "[contact][enforcement]") {
  const std::string formulation = GENERATE(std::string(), node_face);
  const int cells = GENERATE(1, 2, 3);
  ClosingBlocks blocks(formulation, 0.01, cells);
  const Eigen::Matrix3Xd forces = blocks.forces_at({0, 0, -1.0});
  REQUIRE(blocks.report);
  const double size = forces.colwise().norm().sum();
  REQUIRE(size > 0.0);
  CHECK(forces.rowwise().sum().norm() < 1e-12 * size);
  const Eigen::Matrix3Xd after = blocks.velocity_after(forces);
  double lowest = 1.0, highest = -1.0;  // of the interface at the end of the step
  for (Eigen::Index i = 0; i < after.cols(); ++i) {
    const double z = blocks.bodies.x(2, i), at_end = z + ClosingBlocks::step * after(2, i);
    if (z == 1.0) highest = std::max(highest, at_end);
    if (z == 1.01) lowest = std::min(lowest, at_end);
  }
  CHECK(lowest - highest == Approx(0.0).margin(2e-4));
  // What is lost is never gained.
  CHECK(blocks.report->impact_work >= 0.0);
  const auto kinetic = [&](const Eigen::Matrix3Xd& v) {
    return 0.5 * v.cwiseAbs2().cwiseProduct(blocks.bodies.model.mass.replicate<3, 1>()).sum();
  };
  CHECK(kinetic(after) <= kinetic(blocks.state.velocity));
}

TEST_CASE(
    "what has penetrated comes out by the energy that impacts have lost, or that overlaps of the start take",
    "[contact][enforcement]") {
  const std::string formulation = GENERATE(std::string(), node_face);
  const Eigen::Vector3d still = Eigen::Vector3d::Zero();
  ClosingBlocks overlapping(formulation, -1e-3);
  const Eigen::Matrix3Xd after = overlapping.velocity_after(overlapping.forces_at(still));
  const double given =
      0.5 * after.cwiseAbs2().cwiseProduct(overlapping.bodies.model.mass.replicate<3, 1>()).sum();
  CHECK(given > 0.0);
  CHECK(given < overlapping.bodies.contact.recovery_energy().of_overlaps({0}));

  ClosingBlocks blocks(formulation, 1e-3);
  const auto lower = [](ClosingBlocks& lowered) {
    for (Eigen::Index i = 0; i < lowered.bodies.x.cols(); ++i) {
      if (lowered.bodies.x(2, i) > 1.0) lowered.bodies.x(2, i) -= 2e-3;
    }
  };
  CHECK(blocks.forces_at(still).isZero(0.0));
  lower(blocks);
  CHECK(blocks.forces_at(still).isZero(0.0));  // nothing has been lost yet

  const double speed = GENERATE(0.02, 1.0);  // within the gap, and beyond
  ClosingBlocks hit(formulation, 1e-3);
  hit.forces_at({0, 0, -speed});
  REQUIRE(hit.report);
  const double lost = hit.report->impact_work;
  CHECK(lost > 0.0);
  lower(hit);
  CHECK(hit.forces_at(still).norm() > 0.0);
}

TEST_CASE("what a hit takes in the first step is lost", "[contact][enforcement]") {
  const std::string formulation = GENERATE(std::string(), node_face);
  ClosingBlocks blocks(formulation, 0.01, 2);
  blocks.state.dt = 0.0;
  const Eigen::Matrix3Xd forces = blocks.forces_at({0, 0, -1.0});
  REQUIRE(blocks.report);
  // The leapfrog stands mirrored before it: m |v0|^2 / 2 becomes m (|v0|^2 - |v - v0|^2) / 2.
  const Eigen::Matrix3Xd change =
      0.5 * ClosingBlocks::step * forces.cwiseQuotient(blocks.bodies.model.mass.replicate<3, 1>());
  const double taken =
      0.5 * change.cwiseAbs2().cwiseProduct(blocks.bodies.model.mass.replicate<3, 1>()).sum();
  REQUIRE(taken > 0.0);
  CHECK(blocks.report->impact_work == Approx(taken));
}

TEST_CASE("a block whose sides lean out goes on standing on what it touches", "[contact][enforcement]") {
  const std::string formulation = GENERATE(std::string(), node_face);
  const double lean = GENERATE(0.1, 0.3, 0.6, 1.0);  // of the sides, over the height
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {1, 1, 1}, .size = {4, 4, 1}});
  std::vector<std::uint32_t> nodes;
  for (const double up : {0.0, 1.0}) {
    const double low = 1.5 - lean * up, high = 2.5 + lean * up;
    for (const auto& [x, y] : {std::pair(low, low), {high, low}, {high, high}, {low, high}})
      nodes.push_back(b.add_node({x, y, 1.0 + up}).value);
  }
  b.add_block(2, "", Shape::hex8, nodes);
  ClosingBlocks blocks(b, formulation);
  const Eigen::Matrix3Xd first = blocks.forces_at({0, 0, -1.0});
  REQUIRE(blocks.bodies.contact.pair_steps()[{0}].force.norm() > 0.0);
  for (int step = 0; step < 4; ++step) {
    const Eigen::Matrix3Xd next = blocks.forces_at({0, 0, -1.0});
    CHECK((next - first).norm() < 1e-3 * first.norm());
  }
}

TEST_CASE("momentum balance does nothing where the step closes nothing", "[contact][enforcement]") {
  ClosingBlocks blocks("");
  CHECK(blocks.forces_at({0, 0, 1.0}).isZero(0.0));
  CHECK(blocks.forces_at({0.3, 0, 0}).isZero(0.0));
}

TEST_CASE("friction of momentum balance stays on the cone of each contact point", "[contact][enforcement]") {
  const std::string formulation = GENERATE(std::string(), node_face);
  ClosingBlocks blocks(formulation + rough);
  blocks.forces_at({2.0, 0, -1.0});
  double normal = 0.0, along = 0.0;
  for (const ContactPoint& point : blocks.bodies.contact.points()) {
    CHECK(point.force >= 0.0);
    CHECK(point.tangential.norm() <= 0.2 * point.force * (1.0 + 1e-9));
    normal += point.force;
    along += std::abs(point.tangential.x());
  }
  CHECK(normal > 0.0);
  CHECK(along == Approx(0.2 * normal).epsilon(1e-6));  // it slides everywhere
}

TEST_CASE("friction of a hybrid model is that of what was far at the start", "[contact][enforcement]") {
  const std::string formulation = GENERATE(std::string(), node_face);
  ClosingBlocks blocks(formulation +
                       "capture tolerance = 1e-3\nfriction model = either\nend\n"
                       "begin constant friction model slick\nfriction coefficient = 0.05\nend\n"
                       "begin constant friction model rough\nfriction coefficient = 0.2\nend\n"
                       "begin hybrid model either\ninitially close = slick\ninitially far = rough\n");
  blocks.forces_at({2.0, 0, -1.0});
  double normal = 0.0, along = 0.0;
  for (const ContactPoint& point : blocks.bodies.contact.points()) {
    normal += point.force;
    along += std::abs(point.tangential.x());
  }
  REQUIRE(normal > 0.0);
  CHECK(along == Approx(0.2 * normal).epsilon(1e-6));
}

TEST_CASE("what pulls where momentum is balanced limits the next step as it does under penalty",
          "[contact][enforcement]") {
  const std::string formulation = GENERATE(std::string(), by_nodes);
  const auto step_with = [&](const std::string& enforcement) {
    ContactBodies bodies(law_mesh(0.1),
                         "skin all blocks = on\nbegin interaction\nside a = block_1\nside b = block_2\n"
                         "friction model = m\nenforcement = " +
                             enforcement + "\n" + formulation +
                             "end\nbegin adhesion model m\nadhesion function = stick\nend\n",
                         line_function("stick", "0 1\n1 0\n"));
    State state = make_state(bodies.x, bodies.model.blocks, 0.0);
    state.dt = state.next_dt = 1e-3;
    state.velocity = state.acceleration = Eigen::Matrix3Xd::Zero(3, bodies.x.cols());
    bodies.ask();
    bodies.contact.balance(state, bodies.forces);
    return bodies.step(1e-3).stable_step;
  };
  const double of_penalty = step_with("penalty");
  CHECK(std::isfinite(of_penalty));
  // The penalty has springs for what may soon touch, too.
  CHECK(step_with("momentum_balance") == Approx(of_penalty).epsilon(0.2));
}

TEST_CASE("momentum balance has the same bits with one thread and with two", "[contact][enforcement]") {
  ClosingBlocks one(rough, 0.01, 24), two(rough, 0.01, 24);
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const Eigen::Matrix3Xd first = one.forces_at({0.5, 0.1, -1.0});
  omp_set_num_threads(2);
  CHECK(first == two.forces_at({0.5, 0.1, -1.0}));
  omp_set_num_threads(before);
}

}  // namespace momentum_balance_test

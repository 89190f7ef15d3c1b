// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/subcycler.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/graded_rod.hpp"
#include "support/subcycled_run.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// The rod as masses and springs, impulse by impulse: what a step does, as slowly and plainly as can be.
class SpringChain {
 public:
  SpringChain(const GradedRod& rod, double step) : dt_(step) {
    std::map<double, std::size_t> planes;
    const Mesh& mesh = rod.mesh;
    for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) planes[mesh.coordinates()(0, i)] = 0;
    for (auto& [x, plane] : planes) {
      plane = x_.size();
      x_.push_back(x);
    }
    v_.assign(x_.size(), 0.0);
    mass_ = v_;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      if (x_[i] < 5.0) v_[i] = 1e-7;
    }
    rest_ = x_;
    is_small_.assign(x_.size() - 1, false);
    for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
      mass_[i] += 0.5 * (x_[i + 1] - x_[i]);
      mass_[i + 1] += 0.5 * (x_[i + 1] - x_[i]);
    }
    for (const ModelBlock& block : rod.model.blocks) {
      for (const BatchChunk& chunk : block.chunks) {
        for (std::size_t e = n_lanes * chunk.first_batch;
             e < std::min(block.n_elements, n_lanes * (chunk.first_batch + chunk.n_batches)); ++e) {
          const auto nodes = mesh.element_nodes({block.first_element.value + static_cast<std::uint32_t>(e)});
          is_small_[planes.at(mesh.coordinates()(0, nodes[0].value))] = chunk.is_subcycled;
        }
      }
    }
  }

  void step(std::int64_t n_parts) {
    kick(false, 0.5 * dt_);
    const double part = dt_ / static_cast<double>(n_parts);
    for (std::int64_t i = 0; i < n_parts; ++i) {
      kick(true, 0.5 * part);
      for (std::size_t k = 0; k < x_.size(); ++k) x_[k] += part * v_[k];
      kick(true, 0.5 * part);
    }
    kick(false, 0.5 * dt_);
  }
  double displacement(double at) const {
    const auto i = std::ranges::lower_bound(rest_, at - 1e-6) - rest_.begin();
    return x_[static_cast<std::size_t>(i)] - rest_[static_cast<std::size_t>(i)];
  }

 private:
  void kick(bool small, double span) {
    for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
      if (is_small_[i] != small) continue;
      const double length = rest_[i + 1] - rest_[i];
      const double pull = ((x_[i + 1] - rest_[i + 1]) - (x_[i] - rest_[i])) / length;
      v_[i] += span * pull / mass_[i];
      v_[i + 1] -= span * pull / mass_[i + 1];
    }
  }

  double dt_;
  std::vector<double> x_, v_, mass_, rest_;
  std::vector<bool> is_small_;
};

}  // namespace

TEST_CASE("a subcycled rod moves as its impulses say, one by one", "[core][subcycler]") {
  GradedRod rod({.n_large = 20, .n_small = 3, .small_size = 0.13});
  rod.subcycle();
  REQUIRE(rod.model.subcycles.n_elements > 3);
  REQUIRE(rod.model.subcycles.n_others > 8);
  SubcycledRun run(rod.model, strike);
  SpringChain chain(rod, run.state.next_dt);
  for (int step = 0; step < 60; ++step) {
    run.advance(1);
    chain.step(8);
  }
  CHECK(run.state.subcycled.n_parts == 60 * 8);  // 0.85 / (0.9 x 0.13) = 7.3
  double largest = 0.0;
  for (std::uint32_t i = 0; i < rod.mesh.n_nodes(); ++i) {
    const double u = run.state.coordinates(0, i) - rod.mesh.coordinates()(0, i);
    largest = std::max(largest, std::abs(u));
    // Strains of 1e-7 bend the law by as much; coordinates of 40 are known to 1e-14.
    CHECK(u == Approx(chain.displacement(rod.mesh.coordinates()(0, i))).margin(1e-11));
  }
  CHECK(largest > 5e-7);
}

TEST_CASE("a subcycled rod keeps energy and momentum", "[core][subcycler]") {
  GradedRod rod({});
  rod.subcycle();
  SubcycledRun run(rod.model, strike);
  const double before = total(run.state), momentum = run.state.momentum.x();
  REQUIRE(before > 0.0);
  double least = before, greatest = before;
  for (int i = 0; i < 2000; ++i) {
    run.advance(1);
    least = std::min(least, total(run.state));
    greatest = std::max(greatest, total(run.state));
  }
  CHECK(greatest - least < 1e-6 * before);  // strains of 1e-7
  CHECK(run.state.energies.internal > 0.1 * before);
  CHECK(std::abs(run.state.energies.error) / before < 1e-11);
  CHECK(run.state.momentum.x() == Approx(momentum).epsilon(1e-12));
  // The strain energy that elements add up themselves is what the work of forces leaves, `unseen` included.
  double strain_energy = 0.0;
  for (std::size_t b = 0; b < rod.model.blocks.size(); ++b) {
    const StateLayout& layout = rod.model.blocks[b].layout;
    for (std::size_t i = 0; i < rod.model.blocks[b].n_elements; ++i)
      strain_energy += run.state.blocks[b].at(layout, i, layout.energy());
  }
  CHECK(strain_energy / before ==
        Approx((run.state.energies.internal + run.state.energies.unseen) / before).epsilon(0.02));
}

TEST_CASE("without subcycling the same rod takes more steps and comes to the same", "[core][subcycler]") {
  GradedRod rod({.bulk_viscosity = 0.06}), whole({.bulk_viscosity = 0.06});
  rod.subcycle();
  SubcycledRun run(rod.model, strike), reference(whole.model, strike, 0.0, nullptr, std::nullopt);
  run.advance(60);
  while (reference.state.time < run.state.time) reference.advance(1);
  CHECK(reference.state.step > 8 * run.state.step);
  double largest = 0.0, off = 0.0;
  for (std::uint32_t i = 0; i < rod.mesh.n_nodes(); ++i) {
    const double u = reference.state.coordinates(0, i) - rod.mesh.coordinates()(0, i);
    largest = std::max(largest, std::abs(u));
    off = std::max(off, std::abs(run.state.coordinates(0, i) - reference.state.coordinates(0, i)));
  }
  CHECK(off < 0.03 * largest);  // the front is some elements wide, and times differ by a step
}

TEST_CASE("nodes of subcycled elements are held, driven and loaded as others", "[core][subcycler]") {
  GradedRod rod({});
  rod.subcycle();
  // The plane between the small elements.
  PrescribedMotion motion;
  for (std::uint32_t i = 0; i < rod.mesh.n_nodes(); ++i) {
    if (std::abs(rod.mesh.coordinates()(0, i) - 40.1) < 1e-6) motion.nodes.push_back({i});
  }
  REQUIRE(motion.nodes.size() == 4);
  const NodeIndex node = motion.nodes.front();
  REQUIRE(std::ranges::binary_search(rod.model.subcycles.nodes, node));
  motion.direction = Components{{true, false, false}};
  SECTION("held") {
    rod.model.kinematic_constraints = KinematicConstraints(rod.mesh, {motion});
    SubcycledRun run(rod.model, strike);
    const double before = total(run.state);
    run.advance(150);
    CHECK(run.state.coordinates(0, node.value) == rod.mesh.coordinates()(0, node.value));
    CHECK(run.state.velocity(0, node.value) == 0.0);
    CHECK(run.state.acceleration(0, node.value) == 0.0);
    CHECK(std::abs(run.state.energies.external) / before < 1e-12);
    CHECK(total(run.state) == Approx(before).epsilon(1e-6));
    // It does not let waves through.
    CHECK(run.state.coordinates(0, rod.mesh.n_nodes() - 1) ==
          Approx(rod.mesh.coordinates()(0, rod.mesh.n_nodes() - 1)).margin(1e-13));
  }
  SECTION("driven") {
    motion.type = MotionType::velocity;
    motion.value = ConditionFunction(1e-7);
    rod.model.kinematic_constraints = KinematicConstraints(rod.mesh, {motion});
    SubcycledRun run(rod.model, [](State&) {});
    run.advance(30);
    CHECK(run.state.coordinates(0, node.value) - rod.mesh.coordinates()(0, node.value) ==
          Approx(1e-7 * run.state.time).epsilon(1e-6));
    // Two waves of stress v go away from it at speed 1 with velocity v, each with energy v^2 per length.
    CHECK(run.state.energies.external == Approx(2e-14 * run.state.time).epsilon(0.02));
    CHECK(std::abs(run.state.energies.error) / run.state.energies.external < 1e-11);
  }
  SECTION("loaded") {
    // A force on each node that is no share of its mass pulls apart; the whole moves by impulse.
    SubcycledRun run(
        rod.model, [](State&) {}, 1e-9);
    run.advance(30);
    CHECK(run.state.momentum.x() == Approx(1e-9 * rod.mesh.n_nodes() * run.state.time).epsilon(1e-12));
    CHECK(std::abs(run.state.energies.error) / run.state.energies.external < 1e-11);
  }
}

TEST_CASE("what is written of subcycled nodes is mass x acceleration = all forces", "[core][subcycler]") {
  GradedRod rod({});
  rod.subcycle();
  SubcycledRun run(rod.model, strike);
  run.advance(37);
  const State& s = run.state;
  const double largest = s.forces.internal.cwiseAbs().maxCoeff();
  REQUIRE(largest > 0.0);
  const Eigen::Matrix3Xd rest =
      rod.model.mass.replicate<3, 1>().cwiseProduct(s.acceleration) - s.forces.internal;
  CHECK(rest.cwiseAbs().maxCoeff() < 1e-12 * largest);
}

TEST_CASE("a small element that is turned inside out within a step is named", "[core][subcycler]") {
  GradedRod rod({});
  rod.subcycle();
  SubcycledRun run(rod.model, [&](State& state) {
    for (Eigen::Index i = 0; i < state.velocity.cols(); ++i) {
      if (state.coordinates(0, i) < 40.05) state.velocity(0, i) = 2.0;
    }
  });
  const auto go = [&] { run.advance(50); };
  CHECK_THROWS_WITH(go(), Catch::Contains("element 41 of block_2 has turned inside out"));
}

// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/shared_elements.hpp"

#include <cmath>
#include <optional>

#include "core/base/errors.hpp"
#include "core/dynamics/internal_force.hpp"
#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "core/statics/load_steps.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"
#include "support/thread_ranks.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Pulls all nodes along z, more and more.
class PullOnAll final : public ForceTerm {
 public:
  explicit PullOnAll(double size) : size_(size) {}
  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override {
    forces = Eigen::Matrix3Xd::Zero(3, motion.coordinates.cols());
    forces.row(2).setConstant(size_ * motion.time);
    return {};
  }

 private:
  double size_;
};

/// A bar of two chunks of hexahedra, held at an end. Shells are shared in tests/app/cli/static_rank_runs.py.
struct HeldBar {
  HeldBar() : mesh(MeshBuilder().add_hexes({.cells = {16, 8, 8}, .size = {16, 8, 8}}).build()) {
    model.mesh = &mesh;
    ElementProperties steel{ElasticLaw{{160e9, 80e9}}, 7800.0};
    steel.linear_bulk_viscosity = steel.quadratic_bulk_viscosity = 0.0;
    model.blocks.push_back(make_solid_block(mesh, 0, hex8_mean_quadrature, steel));
    model.mass = lumped_mass(mesh, model.blocks);
    PrescribedMotion fixed;
    fixed.direction = Components{{true, true, true}};
    for (std::uint32_t node = 0; node < mesh.n_nodes(); ++node) {
      if (mesh.coordinates()(0, node) == 0.0) fixed.nodes.push_back({node});
    }
    model.kinematic_constraints = KinematicConstraints(mesh, {fixed});
  }

  /// What a run of two load steps has come to.
  struct End {
    State state;
    std::int64_t n_evaluations = 0;
    std::string failure;
  };

  ///   ranks  null: one process that shares nothing
  End run(Ranks* ranks, const SolverSettings& settings, double load) const {
    End end{make_state(mesh.coordinates(), model.blocks, 0.0), 0, ""};
    std::optional<RankShare> share;
    if (ranks != nullptr) share.emplace(*ranks, model, std::span<const NodeIndex>());
    InternalForce own(model, end.state, share ? &*share : nullptr);
    std::optional<SharedElements> shared;
    if (share) shared.emplace(own, *share);
    PullOnAll pull(load);
    LoadPeriod period;
    period.end = 1.0;
    period.increment = 0.5;
    ForceTerm& internal = shared ? static_cast<ForceTerm&>(*shared) : own;
    LoadSteps steps(model, {internal, pull, nullptr, nullptr, share ? &*share : nullptr}, nullptr, settings,
                    LoadSchedule({period}, {}), end.state);
    steps.start();
    try {
      for (int i = 0; i < 2; ++i) {
        steps.advance();
        end.n_evaluations += steps.report().n_evaluations;
      }
    } catch (const SolveError& error) {
      end.failure = error.what();
    }
    return end;
  }

  Mesh mesh;
  Model model;
};

bool are_equal(const State& one, const State& other) {
  for (std::size_t b = 0; b < one.blocks.size(); ++b) {
    const auto &x = one.blocks[b].values, &y = other.blocks[b].values;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if ((x[i] != y[i]).any()) return false;
    }
    if (one.blocks[b].hourglass_work != other.blocks[b].hourglass_work) return false;
  }
  return one.coordinates == other.coordinates && one.forces.internal == other.forces.internal &&
         one.energies.error == other.energies.error && one.time == other.time;
}

void check_ranks(const HeldBar& bar, const SolverSettings& settings, double load, bool fails) {
  const HeldBar::End alone = bar.run(nullptr, settings, load);
  CHECK(alone.failure.empty() == !fails);
  for (const int count : {2, 3, 4, 7}) {
    CAPTURE(count);
    std::vector<HeldBar::End> ends(static_cast<std::size_t>(count));
    ThreadRanks(count).run([&](Ranks& ranks) {
      ends[static_cast<std::size_t>(ranks.rank())] = bar.run(&ranks, settings, load);
    });
    for (const HeldBar::End& end : ends) {
      CHECK(are_equal(end.state, alone.state));
      CHECK(end.n_evaluations == alone.n_evaluations);
      CHECK(end.failure == alone.failure);
    }
  }
}

}  // namespace

TEST_CASE("load steps of ranks that share elements have the bits of one process, each of them all the state",
          "[core][statics][rank_share]") {
  SolverSettings settings;
  settings.cg.target_relative_residual = 1e-3;
  if (GENERATE(false, true)) {
    settings.cg.full_tangent.emplace();
    settings.cg.full_tangent->linear_solver = LinearSolver::multigrid;
  }
  check_ranks(HeldBar(), settings, 1e6, false);
}

TEST_CASE("where no equilibrium is found all ranks have the state of the last one and say the same",
          "[core][statics][rank_share]") {
  SolverSettings settings;
  settings.cg.target_relative_residual = 1e-12;
  settings.cg.max_iterations = 3;
  check_ranks(HeldBar(), settings, 1e9, true);
}

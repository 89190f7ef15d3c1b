// SPDX-License-Identifier: BSD-3-Clause
// A load step of a cube of n x n x n elastic hexahedra, one side held, under an oblique load on all nodes, to
// a millionth of the load: by nodal blocks, a factor and multigrid.
#include <benchmark/benchmark.h>
#include <omp.h>

#include "bench_meshes.hpp"
#include "core/dynamics/internal_force.hpp"
#include "core/elements/element_table.hpp"
#include "core/materials/elastic.hpp"
#include "core/statics/load_steps.hpp"

namespace contactsim::bench {

namespace {

constexpr std::int64_t nodal_blocks = 0;  // in the place of a LinearSolver

/// The same force on every node, whatever it does.
class EvenLoad final : public ForceTerm {
 public:
  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override {
    forces = Eigen::Vector3d(3e2, 0.0, -4e2).replicate(1, motion.coordinates.cols());
    return {};
  }
};

/// A cube of steel, held where z = 0.
struct HeldCube {
  Mesh mesh;
  Model model;

  explicit HeldCube(std::uint32_t n) : mesh(make_hex_cube(n)) {
    model.mesh = &mesh;
    ElementProperties properties{ElasticLaw{{160e9, 80e9}}, 7800.0};
    properties.linear_bulk_viscosity = properties.quadratic_bulk_viscosity = 0.0;
    model.blocks.push_back(
        make_solid_block(mesh, 0, *find_solid_element(Shape::hex8, "mean_quadrature"), properties));
    model.mass = lumped_mass(mesh, model.blocks);
    PrescribedMotion fixed;
    fixed.direction = Components{{true, true, true}};
    for (std::uint32_t node = 0; node < mesh.n_nodes(); ++node) {
      if (mesh.coordinates()(2, node) == 0.0) fixed.nodes.push_back({node});
    }
    model.kinematic_constraints = KinematicConstraints(mesh, {fixed});
  }
};

SolverSettings settings_of(std::int64_t solver) {
  SolverSettings settings;
  settings.cg.target_relative_residual = 1e-6;
  if (solver != nodal_blocks) {
    settings.cg.full_tangent.emplace();
    settings.cg.full_tangent->linear_solver = static_cast<LinearSolver>(solver);
  }
  return settings;
}

/// Arguments: n, solver, threads.
void load_step(benchmark::State& bench) {
  const HeldCube cube(static_cast<std::uint32_t>(bench.range(0)));
  omp_set_num_threads(static_cast<int>(bench.range(2)));
  for (auto _ : bench) {
    bench.PauseTiming();
    State state = make_state(cube.mesh.coordinates(), cube.model.blocks, 0.0);
    InternalForce internal(cube.model, state);
    EvenLoad load;
    LoadPeriod period;
    period.end = period.increment = 1.0;
    bench.ResumeTiming();
    LoadSteps steps(cube.model, {internal, load}, nullptr, settings_of(bench.range(1)),
                    LoadSchedule({period}, {}), state);
    steps.start();
    steps.advance();
    const LoadStepReport& report = steps.report();
    bench.counters["newton_or_cg"] = static_cast<double>(report.search.n_iterations);
    bench.counters["linear_cg"] = static_cast<double>(report.n_linear);
    bench.counters["residuals"] = static_cast<double>(report.n_evaluations);
  }
}

void sizes(benchmark::internal::Benchmark* bench) {
  constexpr auto direct = static_cast<std::int64_t>(LinearSolver::direct),
                 multigrid = static_cast<std::int64_t>(LinearSolver::multigrid);
  for (const std::int64_t n : {10, 20, 30, 40, 60, 100}) {
    for (const std::int64_t solver : {nodal_blocks, direct, multigrid}) {
      // A factor of 40 x 40 x 40 takes minutes, one of 60 x 60 x 60 more memory than most machines have.
      if (solver == direct && n > 30) continue;
      for (const std::int64_t n_threads : {1, 2}) bench->Args({n, solver, n_threads});
    }
  }
}
BENCHMARK(load_step)
    ->Apply(sizes)
    ->ArgNames({"n", "solver", "threads"})
    ->Iterations(1)
    ->Unit(benchmark::kSecond)
    ->UseRealTime();

}  // namespace

}  // namespace contactsim::bench

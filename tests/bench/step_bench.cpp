// SPDX-License-Identifier: BSD-3-Clause
// Whole time steps of a block of 64 x 64 x 64 hexahedra, with all the bookkeeping of a run: elements, sums at
// the nodes, accelerations, one side held, energies, momentum, the next step.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <cmath>

#include "bench_meshes.hpp"
#include "core/dynamics/integrator.hpp"
#include "core/dynamics/internal_force.hpp"
#include "core/elements/element_table.hpp"
#include "core/materials/elastic.hpp"

namespace contactsim::bench {

namespace {

class NoLoads final : public ForceTerm {
 public:
  ForceReport set_forces(const Motion&, Eigen::Matrix3Xd&) override { return {}; }
};

TimeStepControl endless() { return {{TimePeriod{"all", 0.0, {}}}, 1e30}; }

/// Argument: threads.
void whole_step(benchmark::State& bench) {
  const Mesh mesh = make_hex_cube(64);
  omp_set_num_threads(static_cast<int>(bench.range(0)));
  Model model;
  model.mesh = &mesh;
  model.blocks.push_back(make_solid_block(mesh, 0, *find_solid_element(Shape::hex8, "mean_quadrature"),
                                          ElementProperties{ElasticLaw{{160e9, 80e9}}, 7800.0}));
  model.mass = lumped_mass(mesh, model.blocks);
  State state = make_state(mesh.coordinates(), model.blocks, 0.0);
  for (Eigen::Index i = 0; i < state.velocity.cols(); ++i)
    state.velocity(0, i) = 10.0 * std::sin(0.3 * mesh.coordinates()(1, i));
  InternalForce internal(model, state);
  NoLoads none;
  const TimeStepControl control = endless();
  start(model, {internal, none}, control, state);
  for (auto _ : bench) advance(model, {internal, none}, control, state);
  bench.SetItemsProcessed(static_cast<std::int64_t>(bench.iterations()) * mesh.n_elements());
}
BENCHMARK(whole_step)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

}  // namespace contactsim::bench

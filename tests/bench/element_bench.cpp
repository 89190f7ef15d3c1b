// SPDX-License-Identifier: BSD-3-Clause
// Element-steps per second of a block of 64 x 64 x 64 hexahedra: coordinates, velocities, stresses, hourglass
// and viscous forces, energies, stable step and the sums at the nodes.
#include <benchmark/benchmark.h>
#include <omp.h>

#include "bench_meshes.hpp"
#include "core/elements/element_table.hpp"
#include "core/internal_force.hpp"

namespace contactsim::bench {

namespace {

MaterialLaw elastic() { return ElasticLaw{{160e9, 80e9}}; }
MaterialLaw elastic_plastic() { return PlasticLaw<LinearHardening>{{160e9, 80e9}, {200e6, 1e9, 0.0}}; }

/// Argument: threads.
template <auto make_law>
void hexahedra(benchmark::State& bench) {
  const Mesh mesh = make_hex_cube(64);
  omp_set_num_threads(static_cast<int>(bench.range(0)));
  Model model;
  model.mesh = &mesh;
  model.blocks.push_back(make_solid_block(mesh, 0, *find_solid_element(Shape::hex8, "mean_quadrature"),
                                          SolidProperties{make_law(), 7800.0}));
  State state = make_state(mesh.coordinates(), model.blocks, 0.0);
  InternalForce internal(model, state);
  Eigen::Matrix3Xd x = mesh.coordinates(), v = x, forces(3, x.cols());
  // A shear wave of strains near 1 %, which takes the plastic law over its yield stress again and again.
  for (Eigen::Index i = 0; i < x.cols(); ++i)
    v.col(i) = Eigen::Vector3d(std::sin(0.3 * x(1, i)), 0.0, 0.0) * 100.0;
  constexpr double dt = 5e-5;
  for (auto _ : bench) {
    x += dt * v;
    const ForceReport report = internal.set_forces({0.0, dt, x, v}, forces);
    if (!(report.stable_step > dt)) bench.SkipWithError("the step is not stable");
    v = -v;
  }
  bench.SetItemsProcessed(static_cast<std::int64_t>(bench.iterations()) * mesh.n_elements());
}
BENCHMARK(hexahedra<elastic>)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(hexahedra<elastic_plastic>)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

}  // namespace contactsim::bench

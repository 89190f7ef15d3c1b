// SPDX-License-Identifier: BSD-3-Clause
// Element-steps per second of a block of 64 x 64 x 64 hexahedra: coordinates, velocities, stresses, hourglass
// and viscous forces, energies, stable step and the sums at the nodes.
#include <benchmark/benchmark.h>
#include <omp.h>

#include "bench_meshes.hpp"
#include "core/elements/hex_block.hpp"

namespace contactsim::bench {

namespace {

ElasticLaw elastic() { return {{160e9, 80e9}}; }
PlasticLaw<LinearHardening> elastic_plastic() { return {{160e9, 80e9}, {200e6, 1e9, 0.0}}; }

/// Argument: threads.
template <auto make_law>
void hexahedra(benchmark::State& state) {
  const Mesh mesh = make_hex_cube(64);
  omp_set_num_threads(static_cast<int>(state.range(0)));
  HexBlock block(mesh.blocks()[0], make_law(), {7800.0}, mesh.coordinates());
  Eigen::Matrix3Xd x = mesh.coordinates(), v = x, forces(3, x.cols());
  // A shear wave of strains near 1 %, which takes the plastic law over its yield stress again and again.
  for (Eigen::Index i = 0; i < x.cols(); ++i)
    v.col(i) = Eigen::Vector3d(std::sin(0.3 * x(1, i)), 0.0, 0.0) * 100.0;
  constexpr double dt = 5e-5;
  for (auto _ : state) {
    x += dt * v;
    forces.setZero();
    const BlockStep step = block.advance(x, v, dt, forces);
    if (!(step.stable_step > dt)) state.SkipWithError("the step is not stable");
    v = -v;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * mesh.n_elements());
}
BENCHMARK(hexahedra<elastic>)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(hexahedra<elastic_plastic>)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

}  // namespace contactsim::bench

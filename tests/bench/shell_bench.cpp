// SPDX-License-Identifier: BSD-3-Clause
// Element-steps per second of a sheet of shells: coordinates, velocities, stresses in the layers, hourglass
// forces, energies, stable step and the sums of forces and moments at the nodes.
#include <benchmark/benchmark.h>
#include <omp.h>

#include "element_scenes.hpp"

namespace contactsim::bench {

namespace {

constexpr auto elastic = elastic_law, elastic_plastic = elastic_plastic_law,
               ep_power_hard = ep_power_hard_law;

/// Advances a sheet of 512 x 512 shells of a law and some layers. Arguments: layers, threads.
template <auto make_law>
void shells(benchmark::State& bench) {
  omp_set_num_threads(static_cast<int>(bench.range(1)));
  ShellScene scene(512, make_law(), bench.range(0));
  for (auto _ : bench) {
    scene.step();
    if (!(scene.stable_step() > scene.dt)) bench.SkipWithError("the step is not stable");
  }
  bench.SetItemsProcessed(static_cast<std::int64_t>(bench.iterations()) * scene.mesh().n_elements());
}

void with_layers(benchmark::internal::Benchmark* bench) {
  bench->Args({3, 1})->Args({3, 2})->Args({5, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(shells<elastic>)->Apply(with_layers);
BENCHMARK(shells<elastic_plastic>)->Apply(with_layers);
BENCHMARK(shells<ep_power_hard>)->Apply(with_layers);

}  // namespace

}  // namespace contactsim::bench

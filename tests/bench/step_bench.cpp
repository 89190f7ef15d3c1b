// SPDX-License-Identifier: BSD-3-Clause
// Whole time steps of a block of 64 x 64 x 64 hexahedra, with all the bookkeeping of a run: elements, sums at
// the nodes, accelerations, energies, momentum, the next step.
#include <benchmark/benchmark.h>
#include <omp.h>

#include "element_scenes.hpp"

namespace contactsim::bench {

namespace {

/// Argument: threads.
void whole_step(benchmark::State& bench) {
  omp_set_num_threads(static_cast<int>(bench.range(0)));
  WholeStepScene scene(64);
  for (auto _ : bench) scene.step();
  bench.SetItemsProcessed(static_cast<std::int64_t>(bench.iterations()) * scene.mesh().n_elements());
}
BENCHMARK(whole_step)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

}  // namespace contactsim::bench

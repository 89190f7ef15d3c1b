// SPDX-License-Identifier: BSD-3-Clause
// The whole work of contact: search when it is due, tracking, gaps and forces. Two spheres of one layer of
// hexahedra that slide on each other, touching nearly everywhere or a tenth of an edge apart; and two blocks
// of 64 x 64 x 64 hexahedra in impact, with contact's share of the step.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <ctime>

#include "contact_scenes.hpp"
#include "machine_limits.hpp"

namespace contactsim::bench {

namespace {

/// Seconds of wall time and of all processors; on a busy machine only the latter means something.
struct Clock {
  double wall = wall_seconds();
  double cpu = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
};

/// Arguments: faces a sphere, threads, whether the spheres touch.
template <ConstraintFormulation formulation, Enforcement enforcement>
void contact_of_spheres(benchmark::State& bench) {
  omp_set_num_threads(static_cast<int>(bench.range(1)));
  SphereScene scene(bench.range(0), bench.range(2) != 0, {formulation, enforcement});
  double wall = 0.0, cpu = 0.0;
  for (auto _ : bench) {
    bench.PauseTiming();
    scene.move();
    bench.ResumeTiming();
    const Clock begin;
    scene.step();
    const Clock end;
    wall += end.wall - begin.wall;
    cpu += end.cpu - begin.cpu;
  }
  bench.counters["bytes_per_face"] = scene.memory() / scene.n_faces();
  bench.counters["searches"] = static_cast<double>(scene.force().search().n_searches());
  bench.counters["pushed"] = scene.pushed();
  const double node_steps = scene.n_nodes() * static_cast<double>(bench.iterations());
  bench.counters["ns_per_node"] = 1e9 * wall / node_steps;
  bench.counters["cpu_ns_per_node"] = 1e9 * cpu / node_steps;
}

template <std::int64_t n_faces, int n_steps>
void with(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"faces", "threads", "touch"})->Iterations(n_steps);
  for (const int threads : {1, 2}) bench->Args({n_faces, threads, 1});
  bench->Args({n_faces, 1, 0})->Unit(benchmark::kMillisecond)->UseRealTime();
}

constexpr auto face_face = ConstraintFormulation::face_face, node_face = ConstraintFormulation::node_face;
constexpr auto balance = Enforcement::momentum_balance, penalty = Enforcement::penalty;
BENCHMARK_TEMPLATE(contact_of_spheres, node_face, balance)->Apply(with<10000, 200>);
BENCHMARK_TEMPLATE(contact_of_spheres, face_face, balance)->Apply(with<10000, 200>);
BENCHMARK_TEMPLATE(contact_of_spheres, node_face, penalty)->Apply(with<10000, 200>);
BENCHMARK_TEMPLATE(contact_of_spheres, face_face, penalty)->Apply(with<10000, 200>);
BENCHMARK_TEMPLATE(contact_of_spheres, node_face, balance)->Apply(with<100000, 80>);
BENCHMARK_TEMPLATE(contact_of_spheres, face_face, balance)->Apply(with<100000, 80>);
BENCHMARK_TEMPLATE(contact_of_spheres, node_face, balance)->Apply(with<1000000, 40>);
BENCHMARK_TEMPLATE(contact_of_spheres, face_face, balance)->Apply(with<1000000, 40>);

/// Argument: threads.
template <ConstraintFormulation formulation, Enforcement enforcement>
void impact_step(benchmark::State& bench) {
  omp_set_num_threads(static_cast<int>(bench.range(0)));
  ImpactScene scene({formulation, enforcement});
  const double begin = wall_seconds();
  double n_passes = 0.0;
  for (auto _ : bench) {
    scene.step();
    n_passes += scene.force().balance_report().n_iterations;
  }
  const double rest = wall_seconds() - begin - scene.contact_seconds();
  bench.counters["contact_share_of_rest"] = scene.contact_seconds() / rest;
  bench.counters["searches"] = static_cast<double>(scene.force().search().n_searches());
  bench.counters["passes"] = n_passes / static_cast<double>(bench.iterations());
  bench.counters["points"] = static_cast<double>(scene.force().points().size());
  bench.counters["touching"] = scene.force().pair_steps()[{0}].area / (64.0 * 64.0);
  bench.SetItemsProcessed(static_cast<std::int64_t>(bench.iterations()) * scene.mesh().n_elements());
}

void for_threads(benchmark::internal::Benchmark* bench) {
  bench->Arg(1)->Arg(2)->Iterations(60)->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK_TEMPLATE(impact_step, face_face, balance)->Apply(for_threads);
BENCHMARK_TEMPLATE(impact_step, node_face, balance)->Apply(for_threads);
BENCHMARK_TEMPLATE(impact_step, face_face, penalty)->Apply(for_threads);
BENCHMARK_TEMPLATE(impact_step, node_face, penalty)->Apply(for_threads);

}  // namespace

}  // namespace contactsim::bench

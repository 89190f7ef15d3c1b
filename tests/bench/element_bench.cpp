// SPDX-License-Identifier: BSD-3-Clause
// Element-steps per second of cubes of solid elements: coordinates, velocities, stresses, hourglass and
// viscous forces, energies, stable step and the sums at the nodes.
#include <benchmark/benchmark.h>
#include <omp.h>

#include "core/materials/linear_hardening.hpp"
#include "core/materials/mooney_rivlin.hpp"
#include "core/materials/multilinear_hardening.hpp"
#include "core/materials/neo_hookean.hpp"
#include "core/materials/orthotropic.hpp"
#include "core/materials/tearing.hpp"
#include "element_scenes.hpp"

namespace contactsim::bench {

namespace {

MaterialLaw neo_hookean() { return NeoHookeanLaw{steel}; }
MaterialLaw mooney_rivlin() { return MooneyRivlinLaw{steel, 15e9}; }
MaterialLaw orthotropic() {
  return make_orthotropic_law({{}, 300e9, 200e9, 100e9, 0.3, 0.2, 0.4, 80e9, 60e9, 100e9});
}
MaterialLaw kinematic() { return PlasticLaw<LinearHardening>{steel, {200e6, 0.0, 1e9}}; }
/// As steep as a measured curve at first, of ten points.
MultilinearHardening bends() {
  std::vector<FunctionPoint> points;
  for (int i = 0; i < 10; ++i) points.push_back({0.005 * i * i, 200e6 + 1e8 * std::sqrt(0.005 * i * i)});
  return {HardeningCurve(points), 1.0};
}
MaterialLaw multilinear_ep() { return PlasticLaw<MultilinearHardening>{steel, bends()}; }
MaterialLaw ml_ep_fail() { return TearingLaw{{steel, bends()}, 1e9, 0.1}; }

constexpr auto elastic = elastic_law, elastic_plastic = elastic_plastic_law;
constexpr auto ep_power_hard = ep_power_hard_law, johnson_cook = johnson_cook_law;

/// Advances a mesh of one element type and law. Argument: threads.
void advance(benchmark::State& bench, Mesh mesh, const char* formulation, const MaterialLaw& law) {
  omp_set_num_threads(static_cast<int>(bench.range(0)));
  SolidScene scene(std::move(mesh), formulation, law);
  for (auto _ : bench) {
    scene.step();
    if (!(scene.stable_step() > scene.dt)) bench.SkipWithError("the step is not stable");
  }
  bench.SetItemsProcessed(static_cast<std::int64_t>(bench.iterations()) * scene.mesh().n_elements());
}

/// 64 x 64 x 64 cells.
template <auto make_law>
void hexahedra(benchmark::State& bench) {
  advance(bench, make_hex_cube(64), "mean_quadrature", make_law());
}

template <auto make_law>
void selective_hexahedra(benchmark::State& bench) {
  advance(bench, make_hex_cube(64), "selective_deviatoric", make_law());
}

template <auto make_law>
void full_hexahedra(benchmark::State& bench) {
  advance(bench, make_hex_cube(64), "fully_integrated", make_law());
}

/// 40 x 40 x 40 cells of six each.
template <auto make_law>
void tetrahedra(benchmark::State& bench) {
  advance(bench, make_tet_cube(40), "mean_quadrature", make_law());
}

void with_threads(benchmark::internal::Benchmark* bench) {
  bench->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(hexahedra<elastic>)->Apply(with_threads);
BENCHMARK(hexahedra<neo_hookean>)->Apply(with_threads);
BENCHMARK(hexahedra<mooney_rivlin>)->Apply(with_threads);
BENCHMARK(hexahedra<orthotropic>)->Apply(with_threads);
BENCHMARK(hexahedra<elastic_plastic>)->Apply(with_threads);
BENCHMARK(hexahedra<kinematic>)->Apply(with_threads);
BENCHMARK(hexahedra<ep_power_hard>)->Apply(with_threads);
BENCHMARK(hexahedra<johnson_cook>)->Apply(with_threads);
BENCHMARK(hexahedra<multilinear_ep>)->Apply(with_threads);
BENCHMARK(hexahedra<ml_ep_fail>)->Apply(with_threads);
BENCHMARK(selective_hexahedra<elastic>)->Apply(with_threads);
BENCHMARK(selective_hexahedra<elastic_plastic>)->Apply(with_threads);
BENCHMARK(full_hexahedra<elastic>)->Apply(with_threads);
BENCHMARK(tetrahedra<elastic>)->Apply(with_threads);
BENCHMARK(tetrahedra<elastic_plastic>)->Apply(with_threads);

}  // namespace

}  // namespace contactsim::bench

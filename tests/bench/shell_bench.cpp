// SPDX-License-Identifier: BSD-3-Clause
// Element-steps per second of a sheet of shells: coordinates, velocities, stresses in the layers, hourglass
// forces, energies, stable step and the sums of forces and moments at the nodes.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <cmath>

#include "bench_meshes.hpp"
#include "core/dynamics/internal_force.hpp"
#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "core/materials/linear_hardening.hpp"
#include "core/materials/power_hardening.hpp"

namespace contactsim::bench {

namespace {

constexpr ElasticModuli steel{160e9, 80e9};

MaterialLaw elastic() { return ElasticLaw{steel}; }
MaterialLaw elastic_plastic() { return PlasticLaw<LinearHardening>{steel, {200e6, 1e7, 0.0}}; }
MaterialLaw ep_power_hard() { return PlasticLaw<PowerHardening>{steel, {200e6, 500e6, 0.3, 0.001}}; }

/// Advances a sheet of 512 x 512 shells of a law and some layers. Arguments: layers, threads.
template <auto make_law>
void shells(benchmark::State& bench) {
  omp_set_num_threads(static_cast<int>(bench.range(1)));
  const Mesh mesh = make_shell_sheet(512);
  Model model;
  model.mesh = &mesh;
  ShellSettings settings;
  settings.layers = make_layers("gauss", bench.range(0));
  const std::vector<double> thickness(mesh.n_elements(), 0.1);
  model.blocks.push_back(
      make_shell_block(mesh, 0, shell4_bt_shell, ElementProperties{make_law(), 7800.0}, settings, thickness));
  State state = make_state(mesh.coordinates(), model.blocks, 0.0);
  InternalForce internal(model, state);
  Eigen::Matrix3Xd x = mesh.coordinates(), v = x, w = x, forces(3, x.cols()), moments = forces;
  // To and fro by strains near 1 %, which takes the plastic laws over their yield stress in every step.
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    v.col(i) = Eigen::Vector3d(std::sin(0.3 * x(1, i)), 0.0, 0.1 * std::sin(0.2 * x(0, i))) * 2500.0;
    w.col(i) = Eigen::Vector3d(std::sin(0.3 * x(1, i)), std::cos(0.2 * x(0, i)), 0.0) * 100.0;
  }
  constexpr double dt = 2e-5;
  for (auto _ : bench) {
    x += dt * v;
    Motion motion{0.0, dt, x, v};
    motion.angular_velocity = &w;
    const ForceReport report = internal.set_forces(motion, forces);
    internal.set_moments(motion, moments);
    if (!(report.stable_step > dt)) bench.SkipWithError("the step is not stable");
    v = -v;
    w = -w;
  }
  bench.SetItemsProcessed(static_cast<std::int64_t>(bench.iterations()) * mesh.n_elements());
}

void with_layers(benchmark::internal::Benchmark* bench) {
  bench->Args({3, 1})->Args({3, 2})->Args({5, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(shells<elastic>)->Apply(with_layers);
BENCHMARK(shells<elastic_plastic>)->Apply(with_layers);
BENCHMARK(shells<ep_power_hard>)->Apply(with_layers);

}  // namespace

}  // namespace contactsim::bench

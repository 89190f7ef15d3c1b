// SPDX-License-Identifier: BSD-3-Clause
// Skin of 100 x 100 x 100 hexahedra, and contact surfaces of a mesh of 1,000 blocks.
#include <benchmark/benchmark.h>
#include <omp.h>

#include "bench_meshes.hpp"
#include "contact/surfaces/resolve_surfaces.hpp"
#include "core/definition/contact.hpp"
#include "core/mesh/skin.hpp"

namespace contactsim::bench {

namespace {

/// Arguments: elements shuffled (0 or 1), threads.
void skin_of_million_hexes(benchmark::State& state) {
  const Mesh mesh = make_hex_cube(100, 1, state.range(0) != 0);
  const std::vector<std::uint8_t> present(mesh.n_elements(), 1);
  omp_set_num_threads(static_cast<int>(state.range(1)));
  for (auto _ : state) {
    const Skin skin = make_skin(mesh, present);
    if (skin.exterior.size() != 60000) state.SkipWithError("wrong skin");
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * mesh.n_elements());
}
BENCHMARK(skin_of_million_hexes)
    ->ArgNames({"shuffled", "threads"})
    ->ArgsProduct({{0, 1}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Argument: number of surfaces, each the skin of one block of 1,000 (10 x 10 x 10 cells each).
void surfaces_of_million_hexes(benchmark::State& state) {
  const Mesh mesh = make_hex_cube(100, 10);
  ContactDefinition contact;
  for (std::int64_t i = 1; i <= state.range(0); ++i) {
    const std::string block = "block_" + std::to_string(i);
    contact.surface_commands.emplace_back(ContactSurfaceLine{{}, {"surface_of_" + block, {}}, {{block, {}}}});
  }
  omp_set_num_threads(1);
  for (auto _ : state) {
    Diagnostics diagnostics;
    const ContactSurfaces surfaces = resolve_surfaces(contact, {}, mesh, diagnostics);
    if (surfaces.surfaces.size() != contact.surface_commands.size() || diagnostics.has_errors()) {
      state.SkipWithError("wrong surfaces");
    }
  }
}
BENCHMARK(surfaces_of_million_hexes)
    ->Arg(10)
    ->Arg(100)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

}  // namespace contactsim::bench

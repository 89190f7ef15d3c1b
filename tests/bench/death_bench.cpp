// SPDX-License-Identifier: BSD-3-Clause
// One in a hundred elements of a block of 100 x 100 x 100 hexahedra in contact with itself dies in one step,
// scattered all over it: what it costs beyond the step, over an ordinary step of the same run.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <chrono>
#include <random>

#include "bench_meshes.hpp"
#include "contact/enforcement/contact_force.hpp"
#include "contact/mesh/eroded_nodes.hpp"
#include "contact/surfaces/surface_tracker.hpp"
#include "core/definition/simulation.hpp"
#include "core/dynamics/integrator.hpp"
#include "core/dynamics/internal_force.hpp"
#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"

namespace contactsim::bench {

namespace {

class NoLoads final : public ForceTerm {
 public:
  ForceReport set_forces(const Motion&, Eigen::Matrix3Xd&) override { return {}; }
};

/// A region whose only block is skinned and meets itself.
Region make_region() {
  Region region;
  region.contact.emplace();
  region.contact->surface_commands.emplace_back(SkinAllBlocks{});
  region.contact->interaction_defaults.emplace();
  region.contact->interaction_defaults->self_contact = true;
  region.element_deaths.emplace_back();
  return region;
}

Model make_model(const Mesh& mesh) {
  Model model;
  model.mesh = &mesh;
  model.blocks.push_back(
      make_solid_block(mesh, 0, hex8_mean_quadrature, ElementProperties{ElasticLaw{{160e9, 80e9}}, 7800.0}));
  model.mass = lumped_mass(mesh, model.blocks);
  return model;
}

std::vector<ElementIndex> one_in_a_hundred(std::uint32_t n_elements) {
  std::mt19937 random(1);
  std::vector<ElementIndex> dead;
  for (std::uint32_t i = 0; i < n_elements; i += 100)
    dead.push_back({i + static_cast<std::uint32_t>(random() % 100)});
  return dead;
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Argument: threads. Counters: an ordinary step and the death with the step after it, in seconds, and what
/// the death costs beyond a step, in steps: 3 at most are wanted.
void mass_death(benchmark::State& bench) {
  omp_set_num_threads(static_cast<int>(bench.range(0)));
  const Mesh mesh = make_hex_cube(100);
  const Model model = make_model(mesh);
  const Region region = make_region();
  const SimulationDefinition definition;
  Diagnostics reported;
  ContactModel contact = make_contact_model(definition, region, mesh, reported);
  const NodeElements elements(mesh);
  const FaceGroups faces(mesh, elements);
  OwnershipRules rules(find_surface_requests(definition, region, mesh, reported), mesh,
                       region.contact->subdomain);
  SurfaceTracker living(std::move(rules), faces);
  ErodedNodes eroded_nodes(faces, std::vector<std::uint8_t>(mesh.n_elements(), 0));
  const std::vector<TimeSteppingBlock> blocks(1);
  ContactForce force({*region.contact, contact, model, blocks});
  State state = make_state(mesh.coordinates(), model.blocks, 0.0);
  state.velocity.row(0) = 10.0 * mesh.coordinates().row(1);
  state.forces.contact = Eigen::Matrix3Xd::Zero(3, mesh.n_nodes());
  state.blocks[0].life.assign(model.blocks[0].n_batches(), Lanes::Constant(1.0));
  InternalForce internal(model, state);
  NoLoads none;
  const TimeStepControl control({TimePeriod{"all", 0.0, {}}}, 1e30);
  const ForceTerms terms{internal, none, &force};
  start(model, terms, control, state);
  constexpr int n_steps = 10;
  for (int i = 0; i < 2; ++i) advance(model, terms, control, state);
  double begun = now();
  for (int i = 0; i < n_steps; ++i) advance(model, terms, control, state);
  const double step = (now() - begun) / n_steps;
  std::vector<std::uint8_t> alive(mesh.n_elements(), 1);
  const auto dead = one_in_a_hundred(mesh.n_elements());
  for (auto _ : bench) {
    begun = now();
    for (const ElementIndex element : dead) {
      alive[element.value] = 0;
      state.blocks[0].life[element.value / n_lanes](element.value % n_lanes) = 0.0;
    }
    living.update_for_deaths(dead, contact.surfaces);
    eroded_nodes.add(living.rules(), dead, alive);
    force.rebuild_surfaces({state.time, state.dt, state.coordinates, state.velocity}, eroded_nodes.nodes());
    advance(model, terms, control, state);
    const double death = now() - begun;
    bench.counters["step"] = step;
    bench.counters["death_and_step"] = death;
    bench.counters["death_in_steps"] = (death - step) / step;
  }
  bench.counters["faces"] = static_cast<double>(contact.surfaces.surfaces[{0}].faces.size());
}
BENCHMARK(mass_death)->Arg(1)->Arg(2)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

}  // namespace contactsim::bench

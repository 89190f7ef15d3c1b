// SPDX-License-Identifier: BSD-3-Clause
// The whole work of contact: search when it is due, tracking, gaps and forces. Two spheres of one layer of
// hexahedra that slide on each other, touching nearly everywhere or a tenth of an edge apart; and two blocks
// of 64 x 64 x 64 hexahedra in impact, with contact's share of the step.
#include <benchmark/benchmark.h>
#include <malloc.h>
#include <omp.h>

#include <chrono>
#include <cmath>
#include <ctime>

#include "bench_meshes.hpp"
#include "contact/enforcement/contact_force.hpp"
#include "core/definition/contact.hpp"
#include "core/dynamics/integrator.hpp"
#include "core/dynamics/internal_force.hpp"
#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"

namespace contactsim::bench {

namespace {

/// By which a node of the outer sphere moves in a step, over the edge of a face: that of an impact at a
/// hundredth of the speed of sound.
constexpr double slide_per_step = 0.01;

/// Memory that the program has asked for and not given back [bytes].
double memory_in_use() {
  const auto info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

/// Seconds of wall time and of all processors; on a busy machine only the latter means something.
struct Clock {
  double wall = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  double cpu = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
};

/// A layer of hexahedra on a surface of quadrilaterals, inwards or outwards by a length of 1.
ElementBlock add_layer(const QuadSurface& surface, bool inwards, MeshParts& parts) {
  const Eigen::Index first = parts.coordinates.cols(), n = surface.positions.cols();
  parts.coordinates.conservativeResize(3, first + 2 * n);
  const Eigen::RowVectorXd radius = surface.positions.colwise().norm();
  const Eigen::RowVectorXd scale = 1.0 + (inwards ? -1.0 : 1.0) / radius.array();
  parts.coordinates.middleCols(first, n) = surface.positions;
  parts.coordinates.middleCols(first + n, n) = surface.positions * scale.asDiagonal();
  ElementBlock block;
  block.id = static_cast<std::int64_t>(parts.blocks.size()) + 1;
  block.shape = Shape::hex8;
  block.type_name = "HEX8";
  block.nodes_per_element = 8;
  block.n_elements = static_cast<std::uint32_t>(surface.quads.size());
  const auto below = static_cast<std::uint32_t>(inwards ? first + n : first);
  const auto above = static_cast<std::uint32_t>(inwards ? first : first + n);
  for (const auto& quad : surface.quads) {
    for (const std::uint32_t node : quad) block.nodes.push_back(NodeIndex{below + node});
    for (const std::uint32_t node : quad) block.nodes.push_back(NodeIndex{above + node});
  }
  return block;
}

Mesh make_sphere_layers(std::uint32_t n, double gap) {
  const SpherePair pair = make_sphere_pair(n);
  QuadSurface outer = pair.outer;
  const double moved = gap - 0.1;
  for (auto point : outer.positions.colwise()) point += moved * point.normalized();
  MeshParts parts;
  parts.path = "spheres";
  parts.coordinates.resize(3, 0);
  parts.blocks.push_back(add_layer(pair.inner, true, parts));
  parts.blocks.push_back(add_layer(outer, false, parts));
  return Mesh(std::move(parts));
}

ContactSurface surface_of(const std::string& name, std::uint32_t first, std::uint32_t n, int side) {
  ContactSurface surface;
  surface.name = name;
  for (std::uint32_t e = 0; e < n; ++e) surface.faces.push_back(ElementSide(ElementIndex{first + e}, side));
  return surface;
}

/// Contact of two surfaces with everything automatic.
ContactModel make_pair(ContactSurface first, ContactSurface second, ConstraintFormulation formulation,
                       Enforcement enforcement) {
  ContactModel contact;
  contact.surfaces.surfaces = {std::move(first), std::move(second)};
  SurfacePair pair;
  pair.second = {1};
  pair.formulation = formulation;
  pair.enforcement = enforcement;
  contact.pairs.push_back(pair);
  return contact;
}

Model make_model(const Mesh& mesh) {
  Model model;
  model.mesh = &mesh;
  for (std::uint32_t b = 0; b < mesh.blocks().size(); ++b) {
    model.blocks.push_back(make_solid_block(mesh, b, hex8_mean_quadrature,
                                            ElementProperties{ElasticLaw{{160e9, 80e9}}, 7800.0}));
  }
  model.mass = lumped_mass(mesh, model.blocks);
  return model;
}

/// Time that a pressure wave takes along an edge of length 1.
double stable_step() { return 1.0 / std::sqrt((160e9 + 4.0 / 3.0 * 80e9) / 7800.0); }

/// Arguments: faces a sphere, threads, whether the spheres touch. The motion is prescribed; what forces would
/// change of it is thrown away.
template <ConstraintFormulation formulation, Enforcement enforcement>
void contact_of_spheres(benchmark::State& bench) {
  omp_set_num_threads(static_cast<int>(bench.range(1)));
  const auto n = static_cast<std::uint32_t>(std::lround(std::sqrt(bench.range(0) / 6.0)));
  const std::uint32_t n_faces = 6 * n * n;
  const Mesh mesh = make_sphere_layers(n, bench.range(2) != 0 ? -0.03 : 0.1);
  const ContactModel contact = make_pair(surface_of("inner", 0, n_faces, 6),
                                         surface_of("outer", n_faces, n_faces, 5), formulation, enforcement);
  const Model model = make_model(mesh);
  State state = make_state(mesh.coordinates(), model.blocks, 0.0);
  Eigen::Matrix3Xd &x = state.coordinates, &v = state.velocity, forces = v;
  const double dt = stable_step(), radius = n * std::sqrt(6.0 / (4.0 * EIGEN_PI));
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, 2.0, 3.0).normalized();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(slide_per_step / radius, axis).toRotationMatrix();
  const auto n_outer = x.cols() / 2;
  const ContactDefinition definition;
  const double before = memory_in_use();
  ContactForce force({definition, contact, model, {}});
  double wall = 0.0, cpu = 0.0;
  state.next_dt = dt;
  const auto step = [&] {
    force.set_forces({state.time, state.dt, x, v, dt}, forces);
    force.balance(state, forces);
  };
  step();
  state.dt = dt;
  for (auto _ : bench) {
    bench.PauseTiming();
    const Eigen::Matrix3Xd moved = turn * x.rightCols(n_outer);
    v.rightCols(n_outer) = (moved - x.rightCols(n_outer)) / dt;
    x.rightCols(n_outer) = moved;
    state.time += dt;
    bench.ResumeTiming();
    const Clock begin;
    step();
    const Clock end;
    wall += end.wall - begin.wall;
    cpu += end.cpu - begin.cpu;
  }
  const auto n_nodes = static_cast<double>(force.contact_mesh().n_nodes());
  std::size_t n_pushed = 0;
  for (const auto& f : forces.colwise()) n_pushed += f.squaredNorm() > 0.0 ? 1 : 0;
  bench.counters["bytes_per_face"] = (memory_in_use() - before) / (2.0 * n_faces);
  bench.counters["searches"] = static_cast<double>(force.search().n_searches());
  bench.counters["pushed"] = static_cast<double>(n_pushed) / n_nodes;
  const double node_steps = n_nodes * static_cast<double>(bench.iterations());
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

class NoLoads final : public ForceTerm {
 public:
  ForceReport set_forces(const Motion&, Eigen::Matrix3Xd&) override { return {}; }
};

/// Forces with the time that they take.
class Timed final : public ForceTerm {
 public:
  explicit Timed(ForceTerm& term) : term_(term) {}
  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override {
    const auto start = std::chrono::steady_clock::now();
    const ForceReport report = term_.set_forces(motion, forces);
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return report;
  }
  std::optional<ForceReport> balance(const State& state, Eigen::Matrix3Xd& forces) override {
    const auto start = std::chrono::steady_clock::now();
    const auto report = term_.balance(state, forces);
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return report;
  }
  double seconds = 0.0;

 private:
  ForceTerm& term_;
};

/// Two cubes of 64 x 64 x 64, the second one on top of the first.
Mesh make_two_cubes() {
  const Mesh cube = make_hex_cube(64);
  MeshParts parts;
  parts.path = "cubes";
  const Eigen::Index n = cube.coordinates().cols();
  parts.coordinates.resize(3, 2 * n);
  parts.coordinates << cube.coordinates(), cube.coordinates().colwise() + Eigen::Vector3d(0.3, 0.2, 64.0);
  for (std::uint32_t b = 0; b < 2; ++b) {
    ElementBlock block = cube.blocks()[0];
    block.id = b + 1;
    for (NodeIndex& node : block.nodes) node.value += b * static_cast<std::uint32_t>(n);
    parts.blocks.push_back(std::move(block));
  }
  return Mesh(std::move(parts));
}

/// All outside faces of a cube of 64 x 64 x 64 whose elements begin somewhere.
ContactSurface skin_of_cube(const std::string& name, std::uint32_t first) {
  constexpr std::uint32_t n = 64;
  ContactSurface surface;
  surface.name = name;
  for (std::uint32_t e = 0; e < n * n * n; ++e) {
    const std::array<std::uint32_t, 3> at{e % n, e / n % n, e / n / n};
    const std::array<std::uint32_t, 6> edge{at[1], n - 1 - at[0], n - 1 - at[1], at[0], at[2], n - 1 - at[2]};
    for (int side = 1; side <= 6; ++side) {
      if (edge[static_cast<std::size_t>(side - 1)] == 0)
        surface.faces.push_back(ElementSide(ElementIndex{first + e}, side));
    }
  }
  return surface;
}

/// Argument: threads.
template <ConstraintFormulation formulation, Enforcement enforcement>
void impact_step(benchmark::State& bench) {
  omp_set_num_threads(static_cast<int>(bench.range(0)));
  const Mesh mesh = make_two_cubes();
  const Model model = make_model(mesh);
  const ContactModel contact =
      make_pair(skin_of_cube("low", 0), skin_of_cube("high", 64 * 64 * 64), formulation, enforcement);
  State state = make_state(mesh.coordinates(), model.blocks, 0.0);
  state.velocity.rightCols(state.velocity.cols() / 2).row(2).setConstant(-50.0);
  state.forces.contact = Eigen::Matrix3Xd::Zero(3, state.velocity.cols());
  InternalForce internal(model, state);
  const ContactDefinition definition;
  ContactForce force({definition, contact, model, {}});
  Timed timed(force);
  NoLoads none;
  const TimeStepControl control{{TimePeriod{"all", 0.0, {}}}, 1e30};
  start(model, {internal, none, &timed}, control, state);
  timed.seconds = 0.0;
  const auto begin = std::chrono::steady_clock::now();
  double n_passes = 0.0;
  for (auto _ : bench) {
    advance(model, {internal, none, &timed}, control, state);
    n_passes += force.balance_report().n_iterations;
  }
  const double all = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  bench.counters["contact_share_of_rest"] = timed.seconds / (all - timed.seconds);
  bench.counters["searches"] = static_cast<double>(force.search().n_searches());
  bench.counters["passes"] = n_passes / static_cast<double>(bench.iterations());
  bench.counters["points"] = static_cast<double>(force.points().size());
  bench.counters["touching"] = force.pair_steps()[{0}].area / (64.0 * 64.0);
  bench.SetItemsProcessed(static_cast<std::int64_t>(bench.iterations()) * mesh.n_elements());
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

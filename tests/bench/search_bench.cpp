// SPDX-License-Identifier: BSD-3-Clause
// The global search of two concentric spheres of N faces each, one turning in the other: node boxes of the
// inner against face boxes of the outer, all pairs, after every turn. Beside it FCL's own broad phase on the
// same boxes. The label tells how many pairs there are, the same for all.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bench_meshes.hpp"
#include "contact/search/broad_phase.hpp"
#include "support/fcl_boxes.hpp"

namespace contactsim::bench {

namespace {

using test::FclBoxes;

constexpr double turn_per_search = 1e-3;

void add_point(const Eigen::Vector3d& point, Box& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.lo[axis] = std::min(box.lo[axis], point[static_cast<Eigen::Index>(axis)]);
    box.hi[axis] = std::max(box.hi[axis], point[static_cast<Eigen::Index>(axis)]);
  }
}

Box box_around(const Eigen::Vector3d& point) {
  return {{point[0], point[1], point[2]}, {point[0], point[1], point[2]}};
}

/// Boxes of half a width of 0.2 around the nodes.
std::vector<Box> node_boxes(const QuadSurface& surface) {
  std::vector<Box> boxes;
  for (const auto& point : surface.positions.colwise()) {
    boxes.push_back(box_around(point - Eigen::Vector3d::Constant(0.2)));
    add_point(point + Eigen::Vector3d::Constant(0.2), boxes.back());
  }
  return boxes;
}

std::vector<Box> face_boxes(const QuadSurface& surface) {
  std::vector<Box> boxes;
  for (const auto& quad : surface.quads) {
    boxes.push_back(box_around(surface.positions.col(quad[0])));
    for (const std::uint32_t node : quad) add_point(surface.positions.col(node), boxes.back());
  }
  return boxes;
}

/// The inner nodes and the outer faces, whose sphere is turned before every search; making the boxes is not
/// timed.
class Spheres {
 public:
  explicit Spheres(benchmark::State& bench)
      : bench_(bench),
        pair_(make_sphere_pair(static_cast<std::uint32_t>(std::lround(std::sqrt(bench.range(0) / 6.0))))),
        nodes_(node_boxes(pair_.inner)) {
    move();
  }

  void move() {
    turn(pair_.outer, turn_per_search);
    faces_ = face_boxes(pair_.outer);
  }
  void next() {
    bench_.PauseTiming();
    move();
    bench_.ResumeTiming();
  }
  void report(std::size_t n_pairs) {
    const auto n_faces = static_cast<std::int64_t>(faces_.size());
    bench_.SetLabel(std::to_string(n_faces) + " faces, " + std::to_string(n_pairs) + " pairs");
    bench_.SetItemsProcessed(bench_.iterations() * n_faces);
  }
  const std::vector<Box>& nodes() const { return nodes_; }
  const std::vector<Box>& faces() const { return faces_; }

 private:
  benchmark::State& bench_;
  SpherePair pair_;
  std::vector<Box> nodes_, faces_;
};

/// Arguments: faces a sphere, threads.
void search(benchmark::State& bench) {
  omp_set_num_threads(static_cast<int>(bench.range(1)));
  Spheres spheres(bench);
  BroadPhase nodes, faces;
  PairTable lists;
  const auto search_all = [&] {
    if (nodes.update(spheres.nodes()) || faces.update(spheres.faces())) bench.SkipWithError("bad boxes");
    nodes.find_pairs(
        faces, [](std::uint32_t, std::uint32_t) { return true; }, lists);
  };
  search_all();
  for (auto _ : bench) {
    spheres.next();
    search_all();
  }
  spheres.report(lists.partners.size());
  bench.counters["builds"] = static_cast<double>(faces.counts().builds);
  bench.counters["visits"] =
      static_cast<double>(nodes.counts().visits) / static_cast<double>(bench.iterations() + 1);
}

/// The parts of it.
void search_refit(benchmark::State& bench) {
  omp_set_num_threads(static_cast<int>(bench.range(1)));
  Spheres spheres(bench);
  BroadPhase faces;
  if (faces.update(spheres.faces())) bench.SkipWithError("bad boxes");
  for (auto _ : bench) {
    if (faces.update(spheres.faces())) bench.SkipWithError("bad boxes");
  }
  spheres.report(0);
}

void search_build(benchmark::State& bench) {
  omp_set_num_threads(static_cast<int>(bench.range(1)));
  Spheres spheres(bench);
  for (auto _ : bench) benchmark::DoNotOptimize(make_box_tree(spheres.faces()).n_boxes());
  spheres.report(0);
}

/// Argument: faces a sphere. `find` puts the boxes at their places and adds all pairs.
template <class Find>
void time_fcl(benchmark::State& bench, const Find& find) {
  Spheres spheres(bench);
  FclBoxes nodes(spheres.nodes()), faces(spheres.faces());
  std::vector<RowPartner> pairs;
  for (auto _ : bench) {
    spheres.next();
    pairs.clear();
    faces.update(spheres.faces());
    find(spheres, nodes, faces, pairs);
  }
  spheres.report(pairs.size());
}

/// Both trees descended together.
void fcl_two_trees(benchmark::State& bench) {
  time_fcl(bench, [](const Spheres& spheres, FclBoxes& nodes, const FclBoxes& faces, auto& pairs) {
    nodes.update(spheres.nodes());
    nodes.collide(faces, pairs);
  });
}

/// A query for each node, as most programs do it.
void fcl_one_by_one(benchmark::State& bench) {
  time_fcl(bench, [](const Spheres& spheres, FclBoxes& nodes, const FclBoxes& faces, auto& pairs) {
    nodes.move(spheres.nodes());
    nodes.collide_one_by_one(faces, pairs);
  });
}

/// The same number of searches in every benchmark, so that all see the same places.
template <std::int64_t n_faces, int n_threads>
void with(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"faces", "threads"})->Args({n_faces, n_threads})->Iterations(4000000 / n_faces);
  bench->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(search)->Apply(with<10000, 1>);
BENCHMARK(fcl_two_trees)->Apply(with<10000, 1>);
BENCHMARK(fcl_one_by_one)->Apply(with<10000, 1>);
BENCHMARK(search)->Apply(with<100000, 1>);
BENCHMARK(fcl_two_trees)->Apply(with<100000, 1>);
BENCHMARK(fcl_one_by_one)->Apply(with<100000, 1>);
BENCHMARK(search)->Apply(with<1000000, 1>);
BENCHMARK(fcl_two_trees)->Apply(with<1000000, 1>);
BENCHMARK(fcl_one_by_one)->Apply(with<1000000, 1>);
BENCHMARK(search)->Apply(with<10000, 2>);
BENCHMARK(search)->Apply(with<100000, 2>);
BENCHMARK(search)->Apply(with<1000000, 2>);
BENCHMARK(search_refit)->Apply(with<1000000, 1>);
BENCHMARK(search_refit)->Apply(with<1000000, 2>);
BENCHMARK(search_build)->Apply(with<1000000, 1>);

}  // namespace

}  // namespace contactsim::bench

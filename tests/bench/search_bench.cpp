// SPDX-License-Identifier: BSD-3-Clause
// The global search of two concentric spheres of N faces each, one turning in the other: node boxes of the
// inner against face boxes of the outer, all pairs, after every turn. Beside it FCL's own broad phase on the
// same boxes. The label tells how many pairs there are, the same for all.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <string>
#include <vector>

#include "contact/search/broad_phase.hpp"
#include "search_scene.hpp"
#include "support/fcl_boxes.hpp"

namespace contactsim::bench {

namespace {

using test::FclBoxes;

/// The scene, which moves on before every search; making the boxes is not timed.
class Spheres {
 public:
  explicit Spheres(benchmark::State& bench) : bench_(bench), scene_(bench.range(0)) {}

  void next() {
    bench_.PauseTiming();
    scene_.move();
    bench_.ResumeTiming();
  }
  void report(std::size_t n_pairs) {
    const auto n_faces = static_cast<std::int64_t>(faces().size());
    bench_.SetLabel(std::to_string(n_faces) + " faces, " + std::to_string(n_pairs) + " pairs");
    bench_.SetItemsProcessed(bench_.iterations() * n_faces);
  }
  const std::vector<Box>& nodes() const { return scene_.nodes(); }
  const std::vector<Box>& faces() const { return scene_.faces(); }

 private:
  benchmark::State& bench_;
  SearchScene scene_;
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

// SPDX-License-Identifier: BSD-3-Clause
// What MPI ranks would send in a step, counted without running them, and the weak scaling that follows: cubes
// of hexahedra on 2 to 64 ranks. A line for each cube and number of ranks, as a table in Markdown.
//   contactsim_rank_traffic [seconds per element and step of one rank]
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "bench_meshes.hpp"
#include "core/dynamics/rank_traffic.hpp"
#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"

namespace contactsim::bench {

namespace {

/// A network as ranks see it, one rank a port.
struct Network {
  double latency;    ///< of a message [s]
  double bandwidth;  ///< [bytes/s]

  /// What all get goes by doubling: as many messages as there are halvings of the ranks.
  double seconds(const RankTraffic& traffic) const {
    const double n_messages = static_cast<double>(traffic.n_messages) + std::log2(traffic.n_ranks);
    return latency * n_messages +
           static_cast<double>(traffic.bytes_sent + traffic.bytes_gathered) / bandwidth;
  }
};

constexpr Network ethernet{20e-6, 1.25e9}, infiniband{2e-6, 12e9};

/// The share of a step that goes into elements, messages not hidden behind them.
double efficiency(double compute, const Network& network, const RankTraffic& traffic) {
  return compute / (compute * (1.0 + traffic.imbalance) + network.seconds(traffic));
}

void print_rows(std::uint32_t n, double seconds_per_element) {
  const Mesh mesh = make_hex_cube(n);
  Model model;
  model.mesh = &mesh;
  model.blocks.push_back(
      make_solid_block(mesh, 0, hex8_mean_quadrature, ElementProperties{ElasticLaw{}, 7800.0}));
  for (const int n_ranks : {2, 4, 8, 16, 32, 64}) {
    const ChunkShares chunks(model.blocks, n_ranks);
    const NodeShares nodes(model, chunks, {});
    const RankTraffic traffic = find_traffic(model, chunks, nodes);
    const double n_own = static_cast<double>(mesh.n_elements()) / n_ranks;
    const double compute = n_own * seconds_per_element;
    // Of a compact part: 6 n^(2/3) nodes, 2.5 sums at each, 24 bytes a sum.
    const double model_bytes = 6.0 * std::pow(n_own, 2.0 / 3.0) * 2.5 * 24.0;
    fmt::print("| {} | {} | {:.0f} | {:.1f} | {:.1f} | {} | {:.0f} | {:.2f} | {:.0f} | {:.0f} |\n",
               mesh.n_elements(), n_ranks, n_own, 100.0 * traffic.shared_nodes, 100.0 * traffic.imbalance,
               traffic.n_messages, 1e-3 * static_cast<double>(traffic.bytes_sent),
               static_cast<double>(traffic.bytes_sent) / model_bytes,
               100.0 * efficiency(compute, ethernet, traffic),
               100.0 * efficiency(compute, infiniband, traffic));
  }
}

}  // namespace

}  // namespace contactsim::bench

int main(int argc, char** argv) {
  const double seconds_per_element = argc > 1 ? std::atof(argv[1]) : 0.15e-6;
  if (!(seconds_per_element > 0.0)) {
    fmt::print(stderr, "{}: seconds per element and step > 0 are expected\n", argv[0]);
    return 2;
  }
  fmt::print(
      "| elements | ranks | a rank | nodes shared % | imbalance % | messages | kB sent | of the model | "
      "Ethernet % | "
      "InfiniBand % |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::uint32_t n : {22u, 46u, 100u}) contactsim::bench::print_rows(n, seconds_per_element);
}

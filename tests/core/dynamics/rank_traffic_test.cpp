// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/rank_traffic.hpp"

#include <algorithm>
#include <mutex>
#include <stdexcept>

#include "core/dynamics/rank_share.hpp"
#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "support/catch.hpp"
#include "support/lone_shell.hpp"
#include "support/mesh_builder.hpp"
#include "support/thread_ranks.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A bar of five chunks of hexahedra with a sheet of two chunks of shells, whose nodes have moments, beside
/// it.
struct BarAndSheet {
  BarAndSheet()
      : mesh(MeshBuilder()
                 .add_hexes({.cells = {8, 8, 40}})
                 .add_shells(
                     {.id = 2, .cells = {32, 32}, .origin = {0, 0, 40}, .u = {8, 0, 0}, .v = {0, 8, 0}})
                 .build()) {
    model.mesh = &mesh;
    const ElementProperties steel{ElasticLaw{}, 1.0};
    const std::vector<double> thickness(mesh.blocks()[1].n_elements, 0.1);
    model.blocks.push_back(make_solid_block(mesh, 0, hex8_mean_quadrature, steel));
    model.blocks.push_back(make_shell_block(mesh, 1, shell4_bt_shell, steel, gauss_layers(), thickness));
    model.mass = lumped_mass(mesh, model.blocks);
    model.inertia = lumped_inertia(mesh, model.blocks);
  }
  Mesh mesh;
  Model model;
};

/// Ranks that count what they exchange.
class CountedRanks final : public Ranks {
 public:
  explicit CountedRanks(Ranks& ranks) : Ranks(ranks.rank(), ranks.count()), ranks_(ranks) {}
  void gather(std::span<std::byte> all, std::span<const std::size_t> begins) override {
    gathered += all.size();
    ranks_.gather(all, begins);
  }
  void broadcast(std::span<std::byte> all) override { ranks_.broadcast(all); }
  void exchange(std::span<const std::span<const std::byte>> out,
                std::span<const std::span<std::byte>> in) override {
    for (const auto& message : out) {
      bytes += message.size();
      n_messages += message.empty() ? 0 : 1;
    }
    ranks_.exchange(out, in);
  }
  bool wait_for_all(double seconds) override { return ranks_.wait_for_all(seconds); }
  [[noreturn]] void abort(int /*exit_code*/) override { throw std::runtime_error("the ranks are ended"); }

  std::size_t bytes = 0, n_messages = 0, gathered = 0;

 private:
  Ranks& ranks_;
};

}  // namespace

TEST_CASE("what is counted is what ranks send in a step", "[core][rank_traffic]") {
  const BarAndSheet bodies;
  const std::vector<NodeIndex> everywhere{{0}, {1000}};
  const int n_ranks = GENERATE(2, 3, 5);
  std::mutex checking;
  std::size_t bytes = 0, most = 0, n_messages = 0;
  RankTraffic counted;
  ThreadRanks(n_ranks).run([&](Ranks& ranks) {
    CountedRanks counting(ranks);
    RankShare share(counting, bodies.model, everywhere);
    State state = make_state(bodies.mesh.coordinates(), bodies.model.blocks, 0.0);
    std::vector<ChunkStep> steps(bodies.model.blocks[0].chunks.size() + bodies.model.blocks[1].chunks.size());
    share.exchange(steps, state);
    const std::lock_guard lock(checking);
    CHECK(counting.gathered == share.traffic().bytes_gathered);
    bytes += counting.bytes;
    if (counting.bytes > most) n_messages = counting.n_messages;
    most = std::max(most, counting.bytes);
    counted = share.traffic();
  });
  CHECK(counted.bytes_all == bytes);
  CHECK(counted.bytes_sent == most);
  CHECK(counted.n_messages == n_messages);
}

TEST_CASE("of two ranks on a bar a layer of nodes, and what a sum has, is shared", "[core][rank_traffic]") {
  BarAndSheet bodies;
  const Mesh bar = MeshBuilder().add_hexes({.cells = {8, 8, 40}}).build();
  bodies.model.mesh = &bar;
  bodies.model.blocks.pop_back();
  const ChunkShares chunks(bodies.model.blocks, 2);
  const NodeShares nodes(bodies.model, chunks, {});
  // As tests of NodeShares count: both follow the nodes from 1296 to 2047.
  const RankTraffic traffic = find_traffic(bodies.model, chunks, nodes);
  CHECK(traffic.shared_nodes ==
        Approx((2048.0 - 1296.0) / static_cast<double>(bar.n_nodes())).epsilon(1e-12));
  CHECK(traffic.n_messages == 1);
  CHECK(traffic.imbalance == Approx(0.2));
}

// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/rank_share.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "core/mesh/mesh_piece.hpp"
#include "support/catch.hpp"
#include "support/stiffened_bar.hpp"
#include "support/thread_ranks.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

bool have_equal_values(const State& one, const State& other) {
  for (std::size_t b = 0; b < one.blocks.size(); ++b) {
    const auto &x = one.blocks[b].values, &y = other.blocks[b].values;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if ((x[i] != y[i]).any()) return false;
    }
    if (one.blocks[b].hourglass_work != other.blocks[b].hourglass_work) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("ranks that advance their own elements have the bits of one process", "[core][rank_share]") {
  const StiffenedBar bar;
  const State alone = bar.run(nullptr, 20);
  REQUIRE(alone.energies.internal > 0.0);
  for (const int count : {2, 3, 4, 7}) {
    CAPTURE(count);
    std::vector<State> states(static_cast<std::size_t>(count));
    ThreadRanks(count).run(
        [&](Ranks& ranks) { states[static_cast<std::size_t>(ranks.rank())] = bar.run(&ranks, 20); });
    for (const State& state : states) {
      CHECK(state.coordinates == alone.coordinates);
      CHECK(state.rotations.velocity == alone.rotations.velocity);
      CHECK(state.forces.internal == alone.forces.internal);
      CHECK(state.energies.error == alone.energies.error);
      CHECK(state.next_dt == alone.next_dt);
      CHECK(have_equal_values(state, alone));
    }
  }
}

TEST_CASE("a rank knows its piece of the mesh by itself", "[core][rank_share]") {
  StiffenedBar bar;
  const State alone = bar.run(nullptr, 5);
  constexpr int count = 3;
  const std::vector<std::uint32_t> rank_of = find_ranks_of_elements(bar.model, count);
  std::vector<State> states(count);
  ThreadRanks(count).run(
      [&](Ranks& ranks) { states[static_cast<std::size_t>(ranks.rank())] = bar.run(&ranks, 5, false); });
  bool are_all_complete = true;
  for (std::uint32_t rank = 0; rank < count; ++rank) {
    const State& state = states[rank];
    const MeshPiece piece = find_piece(bar.mesh, rank_of, rank);
    REQUIRE_FALSE(piece.nodes.empty());
    for (const std::uint32_t node : piece.nodes) {
      CHECK(state.coordinates.col(node) == alone.coordinates.col(node));
      CHECK(state.acceleration.col(node) == alone.acceleration.col(node));
      CHECK(state.forces.internal.col(node) == alone.forces.internal.col(node));
      CHECK(state.rotations.velocity.col(node) == alone.rotations.velocity.col(node));
    }
    for (std::size_t b = 0; b < 2; ++b) {
      const StateLayout& layout = bar.model.blocks[b].layout;
      for (const std::uint32_t e : piece.elements[b])
        CHECK(state.blocks[b].at(layout, e, 2) == alone.blocks[b].at(layout, e, 2));
    }
    are_all_complete &= have_equal_values(state, alone);
  }
  CHECK_FALSE(are_all_complete);
}

TEST_CASE("a rank advances its own chunks and follows their nodes", "[core][rank_share]") {
  const StiffenedBar bar;
  const auto n_nodes = static_cast<std::int64_t>(bar.mesh.n_nodes());
  std::array<std::int64_t, 2> n_followed{};
  ThreadRanks(2).run([&](Ranks& ranks) {
    const std::vector<NodeIndex> edge = bar.followed_everywhere();
    RankShare share(ranks, bar.model, edge);
    n_followed[static_cast<std::size_t>(ranks.rank())] = share.followed().size();
    std::vector<std::uint8_t> is_followed(bar.mesh.n_nodes(), 0);
    share.followed().visit([&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i) is_followed[static_cast<std::size_t>(i)] = 1;
    });
    for (const NodeIndex node : edge) {
      if (is_followed[node.value] == 0) throw std::logic_error("a node of the edge is not followed");
    }
  });
  CHECK(n_followed[0] + n_followed[1] > n_nodes);
  CHECK(std::max(n_followed[0], n_followed[1]) < n_nodes);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/rank_share.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/dynamics/integrator.hpp"
#include "core/dynamics/internal_force.hpp"
#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "core/mesh/mesh_piece.hpp"
#include "support/catch.hpp"
#include "support/lone_shell.hpp"
#include "support/mesh_builder.hpp"
#include "support/thread_ranks.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

class NoLoad final : public ForceTerm {
 public:
  ForceReport set_forces(const Motion&, Eigen::Matrix3Xd& forces) override {
    forces.setZero();
    return {};
  }
};

/// A bar of two chunks of hexahedra with a sheet of two chunks of shells on it, which share nodes.
struct StiffenedBar {
  StiffenedBar()
      : mesh(MeshBuilder()
                 .add_hexes({.cells = {16, 8, 8}, .size = {16, 8, 8}})
                 .add_shells(
                     {.id = 2, .cells = {32, 32}, .origin = {0, 0, 8}, .u = {32, 0, 0}, .v = {0, 32, 0}})
                 .build()) {
    model.mesh = &mesh;
    const ElementProperties steel{ElasticLaw{{160e9, 80e9}}, 7800.0};
    const std::vector<double> thickness(mesh.blocks()[1].n_elements, 0.1);
    model.blocks.push_back(make_solid_block(mesh, 0, hex8_mean_quadrature, steel));
    model.blocks.push_back(make_shell_block(mesh, 1, shell4_bt_shell, steel, gauss_layers(), thickness));
    model.mass = lumped_mass(mesh, model.blocks);
    model.inertia = lumped_inertia(mesh, model.blocks);
  }

  /// The state after some steps from random velocities.
  ///   completes  whether a rank asks the others for what it does not know
  State run(Ranks* ranks, int n_steps, bool completes = true) const {
    State state = make_state(mesh.coordinates(), model.blocks, 0.0);
    for (Eigen::Index i = 0; i < state.velocity.size(); ++i)
      state.velocity.data()[i] = 100.0 * std::sin(1.7 * static_cast<double>(i * i % 1009));
    std::optional<RankShare> of_rank;
    if (ranks != nullptr) of_rank.emplace(*ranks, model, followed_everywhere());
    RankShare* share = of_rank ? &*of_rank : nullptr;
    InternalForce internal(model, state, share);
    NoLoad none;
    const TimeStepControl control({{"all", 0.0, {}}}, 1e9);
    start(model, {internal, none}, control, state, share);
    for (int step = 0; step < n_steps; ++step) advance(model, {internal, none}, control, state, share);
    if (share != nullptr && completes) share->complete(state);
    return state;
  }

  /// The nodes of an edge, as if something touched it.
  std::vector<NodeIndex> followed_everywhere() const {
    std::vector<NodeIndex> nodes;
    for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) {
      if (mesh.coordinates().col(i).tail<2>().isZero()) nodes.push_back({i});
    }
    return nodes;
  }

  Mesh mesh;
  Model model;
};

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

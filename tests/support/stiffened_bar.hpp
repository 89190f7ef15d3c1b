// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "core/dynamics/integrator.hpp"
#include "core/dynamics/internal_force.hpp"
#include "core/dynamics/rank_share.hpp"
#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "support/lone_shell.hpp"
#include "support/mesh_builder.hpp"

namespace contactsim::test {

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

}  // namespace contactsim::test

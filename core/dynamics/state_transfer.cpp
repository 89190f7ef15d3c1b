// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/state_transfer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/conditions/entity_parts.hpp"
#include "core/dynamics/rigid_motion.hpp"
#include "core/elements/element_table.hpp"
#include "core/mesh/mesh_digest.hpp"

namespace contactsim {

namespace {

/// [n blocks of the mesh] which of them the transfers name.
std::vector<std::uint8_t> find_taken(const ConditionScope& scope,
                                     std::span<const ProceduralTransfer> transfers) {
  std::vector<std::uint8_t> is_taken(scope.mesh.blocks().size(), 0);
  for (const ProceduralTransfer& transfer : transfers) {
    std::vector<std::uint8_t> is_named(is_taken.size(), 0);
    const EntityParts parts =
        find_parts(transfer.set, {"the procedural transfer", transfer.name.location}, scope);
    for (const NamedEntity& part : parts.added) is_named[part.entity.index] = 1;
    for (const NamedEntity& part : parts.removed) is_named[part.entity.index] = 0;
    for (std::size_t i = 0; i < is_taken.size(); ++i)
      is_taken[i] = is_taken[i] != 0 || is_named[i] != 0 ? 1 : 0;
  }
  return is_taken;
}

/// What keeps a block from taking over the state of the other; "" when nothing does.
std::string find_difference(const ModelBlock& earlier, const ModelBlock& block) {
  if (earlier.element != block.element)
    return fmt::format("has elements {} before and {} now", earlier.element->formulation,
                       block.element->formulation);
  if (earlier.is_rigid != block.is_rigid)
    return earlier.is_rigid ? "is rigid before and not now" : "is rigid now and not before";
  if (earlier.material != block.material)
    return fmt::format("is of {} before and of {} now", earlier.material, block.material);
  const bool same_points = earlier.layout.n_points == block.layout.n_points &&
                           earlier.layout.point_size == block.layout.point_size;
  if (!same_points) return "has another section than before";
  const auto differ = [](const std::vector<Lanes>& a, const std::vector<Lanes>& b) {
    return !std::ranges::equal(a, b, [](const Lanes& x, const Lanes& y) { return (x == y).all(); });
  };
  if (differ(earlier.thickness, block.thickness)) return "has another thickness than before";
  return differ(earlier.section, block.section) ? "has another cross-section or radius than before" : "";
}

bool have_one_mesh(const Mesh& a, const Mesh& b) { return &a == &b || digest_of(a) == digest_of(b); }

/// How many moments of drilling each element remembers.
std::size_t n_drilling(const ModelBlock& block) {
  const bool is_shell = !block.thickness.empty() && block.element->has_rotations;
  return is_shell && block.shell.drilling > 0.0 ? block.element->n_nodes : 0;
}

/// Copies what elements remember; drilling that did not count before begins without moments. It stands before
/// the growth of the thickness and the work of the stress, as ShellMemory says.
void copy_values(const ModelBlock& earlier, const ModelBlockState& from, const ModelBlock& block,
                 ModelBlockState& to) {
  constexpr std::size_t n_tail = 2;
  const std::size_t size = block.layout.size(), from_size = earlier.layout.size();
  const std::size_t n_added = size - from_size;
  const std::size_t n_head = n_added > 0 ? from_size - n_tail : from_size;
  for (std::size_t batch = 0; batch < block.n_batches(); ++batch) {
    const auto source = from.values.begin() + static_cast<std::ptrdiff_t>(batch * from_size);
    const auto target = to.values.begin() + static_cast<std::ptrdiff_t>(batch * size);
    const auto head = static_cast<std::ptrdiff_t>(n_head);
    std::copy(source, source + head, target);
    std::fill(target + head, target + head + static_cast<std::ptrdiff_t>(n_added), Lanes::Zero());
    std::copy(source + head, source + static_cast<std::ptrdiff_t>(from_size),
              target + head + static_cast<std::ptrdiff_t>(n_added));
  }
}

/// [n_nodes] which nodes belong to blocks that take over their state.
std::vector<std::uint8_t> find_taken_nodes(const StateTransfer& transfer, const Model& model) {
  std::vector<std::uint8_t> is_taken(model.mesh->n_nodes(), 0);
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    if (!transfer.sources[i]) continue;
    for (const std::uint32_t node : model.blocks[i].chunk_nodes) is_taken[node] = 1;
  }
  return is_taken;
}

/// Finds the bodies of the other model that go on as bodies of this one: those of the same nodes.
void find_bodies(const ConditionScope& scope, const DeckLocation& location, const Model& earlier,
                 const Model& model, StateTransfer& transfer) {
  const std::vector<std::uint8_t> is_taken = find_taken_nodes(transfer, model);
  const auto is_node_taken = [&](NodeIndex node) { return is_taken[node.value] != 0; };
  const std::vector<RigidBody>& others = earlier.rigid.bodies;
  transfer.bodies.resize(model.rigid.bodies.size());
  for (std::size_t i = 0; i < transfer.bodies.size(); ++i) {
    const RigidBody& body = model.rigid.bodies[i];
    if (std::ranges::none_of(body.nodes, is_node_taken)) continue;
    const auto refuse = [&](const char* why) {
      scope.diagnostics.add_error(
          location, fmt::format("the rigid body '{}' cannot take over its state: {}", body.name, why));
    };
    const auto source = std::ranges::find(others, body.nodes, &RigidBody::nodes);
    if (source == others.end()) {
      refuse("no rigid body of the procedure before has the same nodes");
    } else if (!std::ranges::all_of(body.nodes, is_node_taken)) {
      refuse("some of its nodes belong to blocks that the transfer does not name");
    } else {
      transfer.bodies[i] = static_cast<std::size_t>(source - others.begin());
    }
  }
}

/// Puts bodies where those of the other model are. They move as their nodes do, or as the initial conditions
/// had them move where the mesh has them.
void take_over_bodies(const StateTransfer& transfer, const Model& earlier, const State& from,
                      const Model& model, State& state) {
  state.rigid.clear();
  start_rigid_bodies(model, state);
  for (std::size_t i = 0; i < transfer.bodies.size(); ++i) {
    if (!transfer.bodies[i]) continue;
    const RigidBodyState& source = from.rigid[*transfer.bodies[i]];
    // The centre of mass is another where one of the decks gives a mass.
    const Eigen::Vector3d shift =
        model.rigid.bodies[i].centre - earlier.rigid.bodies[*transfer.bodies[i]].centre;
    RigidBodyState& target = state.rigid[i];
    target.position = source.position + source.orientation * shift;
    target.orientation = source.orientation;
    target.angle = source.angle;
    set_node_velocities(model.rigid.bodies[i], target, state);
  }
}

/// Copies columns of the nodes that are marked.
void copy_columns(const std::vector<std::uint8_t>& is_taken, const Eigen::Matrix3Xd& from,
                  Eigen::Matrix3Xd& to) {
  for (std::size_t i = 0; i < is_taken.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    if (is_taken[i] != 0) to.col(column) = from.col(column);
  }
}

/// The energies of a run that goes on without kinetic energy yet, and without errors of its own.
Energies begin_anew(const Energies& ended) {
  Energies energies = ended;
  energies.kinetic = energies.unseen = energies.error = 0.0;
  energies.start = energies.internal + energies.contact - energies.external;
  return energies;
}

}  // namespace

bool StateTransfer::is_whole() const {
  return std::ranges::all_of(sources, [](const auto& source) { return source.has_value(); });
}

StateTransfer find_state_transfer(const ConditionScope& scope, std::span<const ProceduralTransfer> transfers,
                                  const Model& earlier, const Model& model) {
  StateTransfer transfer;
  transfer.sources.resize(model.blocks.size());
  const DeckLocation& location = transfers.front().name.location;
  if (!have_one_mesh(*earlier.mesh, *model.mesh)) {
    scope.diagnostics.add_error(location, "the procedure before works on another mesh",
                                "a state is taken over on the same nodes and elements alone");
    return transfer;
  }
  const std::vector<std::uint8_t> is_taken = find_taken(scope, transfers);
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const ModelBlock& block = model.blocks[i];
    if (is_taken[block.mesh_block] == 0) continue;
    const auto source = std::ranges::find(earlier.blocks, block.mesh_block, &ModelBlock::mesh_block);
    const std::string difference = find_difference(*source, block);
    if (!difference.empty()) {
      const std::string name = scope.mesh.name({EntityKind::block, block.mesh_block});
      scope.diagnostics.add_error(
          location, fmt::format("the block '{}' cannot take over its state: it {}", name, difference));
      continue;
    }
    transfer.sources[i] = static_cast<std::size_t>(source - earlier.blocks.begin());
  }
  find_bodies(scope, location, earlier, model, transfer);
  return transfer;
}

void keep_drilling(const StateTransfer& transfer, const Model& earlier, Model& model) {
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    if (!transfer.sources[i]) continue;
    const ModelBlock& before = earlier.blocks[*transfer.sources[i]];
    ModelBlock& block = model.blocks[i];
    if (n_drilling(before) == 0 || n_drilling(block) > 0) continue;
    block.shell.drilling = before.shell.drilling;
    block.layout.n_own += block.element->n_nodes;
  }
}

void take_over(const StateTransfer& transfer, const Model& earlier, const State& from, const Model& model,
               State& state) {
  const std::vector<std::uint8_t> is_taken = find_taken_nodes(transfer, model);
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    if (!transfer.sources[i]) continue;
    const ModelBlock& block = model.blocks[i];
    const ModelBlockState& source = from.blocks[*transfer.sources[i]];
    ModelBlockState& target = state.blocks[i];
    copy_values(earlier.blocks[*transfer.sources[i]], source, block, target);
    if (!source.life.empty()) target.life = source.life;
    target.hourglass_work = source.hourglass_work;
  }
  if (!model.rigid.empty()) take_over_bodies(transfer, earlier, from, model, state);
  state.death.dying = from.death.dying;
  copy_columns(is_taken, from.coordinates, state.coordinates);
  if (state.rotations.exist() && from.rotations.exist())
    copy_columns(is_taken, from.rotations.angle, state.rotations.angle);
  if (transfer.is_whole()) state.energies = begin_anew(from.energies);
  if (!transfer.takes_velocities) return;
  copy_columns(is_taken, from.velocity, state.velocity);
  if (state.rotations.exist() && from.rotations.exist())
    copy_columns(is_taken, from.rotations.velocity, state.rotations.velocity);
}

}  // namespace contactsim

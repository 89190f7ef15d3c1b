// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/energy_balance.hpp"

#include <algorithm>
#include <array>

#include "core/base/threads.hpp"
#include "core/dynamics/node_groups.hpp"
#include "core/dynamics/rank_share.hpp"

namespace contactsim {

namespace {

/// Groups whose sums are made together.
constexpr Eigen::Index groups_per_chunk = 3 * Eigen::Index{nodes_per_sum} / group_size;

/// The sums of a chunk, component by component.
struct GroupSums {
  NodeGroup kinetic = NodeGroup::Zero(), conserved = NodeGroup::Zero(), unseen = NodeGroup::Zero();
  NodeGroup momentum = NodeGroup::Zero();
  NodeGroup internal_ended = NodeGroup::Zero(), internal_begun = NodeGroup::Zero();
  NodeGroup external_ended = NodeGroup::Zero(), external_begun = NodeGroup::Zero();
  NodeGroup contact_ended = NodeGroup::Zero(), contact_begun = NodeGroup::Zero();

  /// Half steps are weighted with their sizes here.
  ///   half_behind  as half_before; at the start, which has none, half_after
  EnergyBalance total(double half_before, double half_after, double half_behind) const {
    EnergyBalance balance;
    balance.kinetic = 0.5 * kinetic.sum();
    balance.conserved = 0.5 * conserved.sum();
    balance.unseen = 0.5 * half_behind * half_after * unseen.sum();
    balance.ended = {half_before * internal_ended.sum(), half_before * external_ended.sum(),
                     half_before * contact_ended.sum()};
    balance.begun = {half_after * internal_begun.sum(), half_after * external_begun.sum(),
                     half_after * contact_begun.sum()};
    for (Eigen::Index i = 0; i < 3; ++i) {
      balance.momentum(i) = 0.0;
      for (Eigen::Index k = i; k < group_size; k += 3) balance.momentum(i) += momentum(k);
    }
    return balance;
  }
};

void add(const HalfStepWork& part, HalfStepWork& sum) {
  sum.internal += part.internal;
  sum.external += part.external;
  sum.contact += part.contact;
}

/// What nodes do as they move, or as they turn: then inertias, moments and angular velocities.
struct NodeMotion {
  const Eigen::RowVectorXd& mass;
  const NodalForces& forces;
  const Eigen::Matrix3Xd& acceleration;
  Eigen::Matrix3Xd& velocity;
};

/// Walks the nodes in groups; the last one is filled up with zeros.
class Completion {
 public:
  Completion(const NodeMotion& nodes, const State& state) : nodes_(nodes), size_(nodes.velocity.size()) {
    half_before_ = 0.5 * state.dt;
    half_after_ = 0.5 * state.next_dt;
    // Before the first step the leapfrog stands mirrored, as if it had come with the step that follows.
    product_span_ = state.dt > 0.0 ? half_before_ + half_after_ : 2.0 * half_after_;
  }

  std::size_t n_chunks() const {
    const Eigen::Index per_chunk = groups_per_chunk * group_size;
    return static_cast<std::size_t>((size_ + per_chunk - 1) / per_chunk);
  }

  EnergyBalance complete_chunk(std::size_t chunk) {
    GroupSums sums;
    const Eigen::Index first = static_cast<Eigen::Index>(chunk) * groups_per_chunk * group_size;
    const Eigen::Index end = std::min(size_, first + groups_per_chunk * group_size);
    for (Eigen::Index i = first; i < end; i += group_size) complete_group(i, sums);
    return sums.total(half_before_, half_after_, product_span_ - half_after_);
  }

  /// Brings nodes to now whose sums another rank makes.
  void complete(NodeRange nodes) {
    double* v = nodes_.velocity.data();
    const double* a = nodes_.acceleration.data();
    for (std::int64_t i = 3 * nodes.begin; i < 3 * nodes.end; ++i) v[i] += half_before_ * a[i];
  }

 private:
  NodeGroup load(const Eigen::Matrix3Xd& values, Eigen::Index i) const {
    if (i + group_size <= size_) return Eigen::Map<const NodeGroup>(values.data() + i);
    NodeGroup group = NodeGroup::Zero();
    group.head(size_ - i) = Eigen::Map<const Eigen::ArrayXd>(values.data() + i, size_ - i);
    return group;
  }

  NodeGroup load_masses(Eigen::Index node) const {
    const Eigen::Index n_nodes = nodes_.mass.size();
    if (node + nodes_per_group <= n_nodes) return repeat_thrice(nodes_.mass.data() + node);
    std::array<double, nodes_per_group> masses{};
    std::copy(nodes_.mass.data() + node, nodes_.mass.data() + n_nodes, masses.begin());
    return repeat_thrice(masses.data());
  }

  void complete_group(Eigen::Index i, GroupSums& sums) {
    const NodeGroup a = load(nodes_.acceleration, i), mass = load_masses(i / 3);
    const NodeGroup before = load(nodes_.velocity, i);
    const NodeGroup now = before + half_before_ * a, after = now + half_after_ * a;
    const Eigen::Index n = std::min(group_size, size_ - i);
    Eigen::Map<Eigen::ArrayXd>(nodes_.velocity.data() + i, n) = now.head(n);
    // In this order infinite where something pushes a node of next to no mass.
    sums.kinetic += now * now * mass;
    sums.conserved += after * (after - product_span_ * a) * mass;
    sums.momentum += mass * now;
    const NodeGroup internal = load(nodes_.forces.internal, i);
    sums.unseen += (internal != 0.0).select(a * a * mass, 0.0);
    sums.internal_ended += internal * before;
    sums.internal_begun += internal * after;
    if (nodes_.forces.external.size() > 0) {
      const NodeGroup external = load(nodes_.forces.external, i);
      sums.external_ended += external * before;
      sums.external_begun += external * after;
    }
    if (nodes_.forces.contact.size() == 0) return;
    const NodeGroup contact = load(nodes_.forces.contact, i);
    sums.contact_ended += contact * before;
    sums.contact_begun += contact * after;
  }

  NodeMotion nodes_;
  Eigen::Index size_;
  double half_before_, half_after_, product_span_;
};

Eigen::Vector3d reaction_at(const NodeMotion& nodes, NodeIndex node) {
  const Eigen::Index i = node.value;
  const NodalForces& forces = nodes.forces;
  Eigen::Vector3d reaction = nodes.mass(i) * nodes.acceleration.col(i) - forces.internal.col(i);
  if (forces.external.size() > 0) reaction -= forces.external.col(i);
  if (forces.contact.size() > 0) reaction -= forces.contact.col(i);
  return reaction;
}

/// Work of the reactions, with the velocities already those of now.
void add_reactions(const NodeMotion& nodes, std::span<const NodeIndex> held, const State& state,
                   EnergyBalance& balance) {
  const double half_before = 0.5 * state.dt, half_after = 0.5 * state.next_dt;
  for (const NodeIndex node : held) {
    const Eigen::Vector3d a = nodes.acceleration.col(node.value), v = nodes.velocity.col(node.value);
    const Eigen::Vector3d reaction = reaction_at(nodes, node);
    balance.ended.external += half_before * reaction.dot(v - half_before * a);
    balance.begun.external += half_after * reaction.dot(v + half_after * a);
  }
}

EnergyBalance complete_nodes(const NodeMotion& nodes, const State& state, RankShare* share) {
  Completion completion(nodes, state);
  std::vector<EnergyBalance> parts(completion.n_chunks());
  const auto n_nodes = static_cast<std::size_t>(nodes.velocity.cols());
  if (share == nullptr) {
    parallel_for(parts.size(), threads_for(n_nodes),
                 [&](std::size_t i) { parts[i] = completion.complete_chunk(i); });
  } else {
    parallel_for(parts.size(), threads_for(n_nodes), [&](std::size_t i) {
      if (share->makes_sum(i)) parts[i] = completion.complete_chunk(i);
    });
    share->others_followed().visit([&](std::int64_t begin, std::int64_t end) {
      completion.complete({begin, end});
    });
    share->complete_sums(parts);
  }
  EnergyBalance balance;
  balance.momentum.setZero();
  for (const EnergyBalance& part : parts) {
    balance.kinetic += part.kinetic;
    balance.conserved += part.conserved;
    balance.unseen += part.unseen;
    balance.momentum += part.momentum;
    add(part.ended, balance.ended);
    add(part.begun, balance.begun);
  }
  return balance;
}

NodeMotion turning_nodes(const Model& model, NodalRotations& rotations) {
  const Eigen::RowVectorXd& inertia = model.rigid.empty() ? model.inertia : model.rigid.free_inertia;
  return {inertia, rotations.moments, rotations.acceleration, rotations.velocity};
}

}  // namespace

Eigen::Vector3d reaction_at(const Model& model, const State& state, NodeIndex node) {
  Eigen::Matrix3Xd unused;
  return reaction_at({model.mass, state.forces, state.acceleration, unused}, node);
}

Eigen::Vector3d reaction_moment_at(const Model& model, const State& state, NodeIndex node) {
  Eigen::Matrix3Xd unused;
  return reaction_at({model.inertia, state.rotations.moments, state.rotations.acceleration, unused}, node);
}

EnergyBalance complete_velocities(const Model& model, State& state, RankShare* share) {
  const Eigen::RowVectorXd& mass = model.rigid.empty() ? model.mass : model.rigid.free_mass;
  const NodeMotion moving{mass, state.forces, state.acceleration, state.velocity};
  EnergyBalance balance = complete_nodes(moving, state, share);
  add_reactions(moving, model.kinematic_constraints.nodes(), state, balance);
  if (!state.rotations.exist()) return balance;
  const NodeMotion turning = turning_nodes(model, state.rotations);
  EnergyBalance rotational = complete_nodes(turning, state, share);
  add_reactions(turning, model.rotation_constraints.nodes(), state, rotational);
  balance.kinetic += rotational.kinetic;
  balance.conserved += rotational.conserved;
  balance.unseen += rotational.unseen;
  add(rotational.ended, balance.ended);
  add(rotational.begun, balance.begun);
  return balance;
}

}  // namespace contactsim

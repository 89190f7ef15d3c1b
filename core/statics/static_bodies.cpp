// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/static_bodies.hpp"

#include <algorithm>
#include <cmath>

namespace contactsim {

namespace {

/// [a]: [a] b = a x b.
Eigen::Matrix3d cross_product_by(const Eigen::Vector3d& a) {
  Eigen::Matrix3d matrix;
  matrix << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return matrix;
}

/// J of a rotation vector: by what a change of the vector turns further.
Eigen::Matrix3d turning_by_change(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  const bool is_small = angle < 1e-3;  // where the series is exact to round-off
  const double square = angle * angle;
  const double first = is_small ? 0.5 - square / 24.0 : (1.0 - std::cos(angle)) / square;
  const double second = is_small ? 1.0 / 6.0 - square / 120.0 : (angle - std::sin(angle)) / (square * angle);
  const Eigen::Matrix3d cross = cross_product_by(vector);
  return Eigen::Matrix3d::Identity() + first * cross + second * cross * cross;
}

/// The distance of the farthest node from the centre; of a body that has none apart, the radius of gyration
/// [length].
double length_of(const RigidBody& body) {
  const double farthest = body.arms.cols() > 0 ? body.arms.colwise().norm().maxCoeff() : 0.0;
  if (farthest > 0.0) return farthest;
  const double gyration = std::sqrt(body.inertia.trace() / body.mass);
  return gyration > 0.0 ? gyration : 1.0;
}

}  // namespace

StaticBodies::StaticBodies(const Model& model, State& state)
    : model_(model), state_(state), n_mesh_(static_cast<std::uint32_t>(state.coordinates.cols())) {
  for (const RigidBody& one : model.rigid.bodies) {
    lengths_.push_back(length_of(one));
    turns_.emplace_back(Eigen::Matrix3d::Identity() / lengths_.back());
  }
}

bool StaticBodies::are_free() const {
  return model_.rigid.kinematic_constraints.never_free().size() < size() ||
         model_.rigid.rotation_constraints.never_free().size() < size();
}

void StaticBodies::begin_step() {
  start_ = state_.rigid;
  for (std::uint32_t i = 0; i < size(); ++i) turns_[i] = Eigen::Matrix3d::Identity() / lengths_[i];
}

void StaticBodies::add_free(std::vector<FreeDirections>& free) const {
  for (FreeDirections one : model_.rigid.kinematic_constraints.find_free_directions(state_.time)) {
    one.node.value = centre_node(one.node.value);
    free.push_back(one);
  }
  for (FreeDirections one : model_.rigid.rotation_constraints.find_free_directions(state_.time)) {
    one.node.value = turning_node(one.node.value);
    free.push_back(one);
  }
}

void StaticBodies::set_prescribed(double dt, Eigen::VectorXd& prescribed) const {
  const Eigen::Matrix3Xd still = Eigen::Matrix3Xd::Zero(3, Eigen::Index{size()});
  Eigen::Matrix3Xd position = still, angle = still, moves = still, turns = still;
  for (std::uint32_t i = 0; i < size(); ++i) {
    position.col(i) = state_.rigid[i].position;
    angle.col(i) = state_.rigid[i].angle;
  }
  // Accelerations from rest whose half step brings the mean velocity of the step about.
  model_.rigid.kinematic_constraints.constrain({state_.time, dt, dt, position, still}, moves);
  model_.rigid.rotation_constraints.constrain({state_.time, dt, dt, position, still, &angle}, turns);
  for (std::uint32_t i = 0; i < size(); ++i) {
    prescribed.segment<3>(3 * Eigen::Index{centre_node(i)}) = dt * dt * moves.col(i);
    prescribed.segment<3>(3 * Eigen::Index{turning_node(i)}) = dt * dt * lengths_[i] * turns.col(i);
  }
}

void StaticBodies::move(const Eigen::VectorXd& increment, double dt, const Eigen::Matrix3Xd& start) {
  for (std::uint32_t i = 0; i < size(); ++i) {
    const RigidBody& fixed = body(i);
    RigidBodyState& moving = state_.rigid[i];
    const Eigen::Vector3d way = increment.segment<3>(3 * Eigen::Index{centre_node(i)});
    const Eigen::Vector3d turn = increment.segment<3>(3 * Eigen::Index{turning_node(i)}) / lengths_[i];
    moving.position = start_[i].position + way;
    moving.orientation = (turn_by(turn) * start_[i].orientation).normalized();
    moving.angle = start_[i].angle + turn;
    moving.now = {way / dt, turn / dt, Eigen::Vector3d::Zero()};
    moving.before = moving.after = moving.now;
    turns_[i] = turning_by_change(turn) / lengths_[i];
    const Eigen::Matrix3Xd arms = moving.orientation.toRotationMatrix() * fixed.arms;
    for (std::size_t k = 0; k < fixed.nodes.size(); ++k) {
      const Eigen::Index node = fixed.nodes[k].value;
      const Eigen::Vector3d besides = state_.coordinates.col(node) - start.col(node);
      state_.coordinates.col(node) = moving.position + arms.col(static_cast<Eigen::Index>(k)) + besides;
      state_.velocity.col(node) = (state_.coordinates.col(node) - start.col(node)) / dt;
      if (!state_.rotations.exist()) continue;
      state_.rotations.angle.col(node) += turn;
      state_.rotations.velocity.col(node) += turn / dt;
    }
  }
}

void StaticBodies::gather(const std::vector<RigidBodyState>& bodies,
                          const std::vector<Eigen::Matrix3d>& turns, Eigen::VectorXd& forces) const {
  const Eigen::Index n = 3 * Eigen::Index{n_nodes()};
  for (std::uint32_t i = 0; i < size(); ++i) {
    const Eigen::Matrix3Xd arms = bodies[i].orientation.toRotationMatrix() * body(i).arms;
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = force;
    for (std::size_t k = 0; k < body(i).nodes.size(); ++k) {
      const Eigen::Index place = 3 * Eigen::Index{body(i).nodes[k].value};
      const Eigen::Vector3d here = forces.segment<3>(place);
      force += here;
      moment += Eigen::Vector3d(arms.col(static_cast<Eigen::Index>(k))).cross(here);
      forces.segment<3>(place).setZero();
      if (forces.size() == n) continue;
      moment += forces.segment<3>(n + place);
      forces.segment<3>(n + place).setZero();
    }
    forces.segment<3>(3 * Eigen::Index{centre_node(i)}) += force;
    forces.segment<3>(3 * Eigen::Index{turning_node(i)}) += turns[i].transpose() * moment;
  }
}

void StaticBodies::gather_at_start(Eigen::VectorXd& forces) const {
  std::vector<Eigen::Matrix3d> turns;
  for (const double length : lengths_) turns.emplace_back(Eigen::Matrix3d::Identity() / length);
  gather(start_, turns, forces);
}

void StaticBodies::note_forces(const std::vector<FreeDirections>& free) {
  const NodalForces& moments = state_.rotations.moments;
  for (std::uint32_t i = 0; i < size(); ++i) {
    RigidBodyState& moving = state_.rigid[i];
    moving.force.setZero();
    moving.moment.setZero();
    for (const NodeIndex node : body(i).nodes) {
      const Eigen::Vector3d force = state_.forces.at(node.value);
      moving.force += force;
      moving.moment += Eigen::Vector3d(state_.coordinates.col(node.value) - moving.position).cross(force);
      if (!state_.rotations.exist()) continue;
      moving.moment += moments.internal.col(node.value) + moments.external.col(node.value);
      if (moments.contact.cols() > 0) moving.moment += moments.contact.col(node.value);
    }
    moving.reaction.setZero();
    moving.reaction_moment.setZero();
    moving.acceleration.setZero();
    moving.angular_acceleration.setZero();
  }
  for (const FreeDirections& one : free) {
    if (is_of_mesh(one.node.value)) continue;
    RigidBodyState& moving = state_.rigid[owner(one.node.value)];
    if (one.node.value == centre_node(owner(one.node.value)))
      moving.reaction = one.projection * moving.force - moving.force;
    else
      moving.reaction_moment = one.projection * moving.moment - moving.moment;
  }
}

std::vector<Carrier> StaticBodies::carriers(std::uint32_t node, bool turns) const {
  if (!moves(node)) return {{node, turns, Eigen::Matrix3d::Identity()}};
  const std::uint32_t i = body_of(node);
  if (turns) return {{turning_node(i), false, turns_[i]}};
  const Eigen::Vector3d arm = state_.coordinates.col(node) - state_.rigid[i].position;
  return {{centre_node(i), false, Eigen::Matrix3d::Identity()},
          {turning_node(i), false, -cross_product_by(arm) * turns_[i]}};
}

Eigen::Matrix3d StaticBodies::turning_stiffness(std::uint32_t i) const {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const NodeIndex node : body(i).nodes) {
    const Eigen::Vector3d force = state_.forces.at(node.value);
    const Eigen::Vector3d arm = state_.coordinates.col(node.value) - state_.rigid[i].position;
    const Eigen::Matrix3d product = arm * force.transpose();
    sum += product.trace() * Eigen::Matrix3d::Identity() - 0.5 * (product + product.transpose());
  }
  return sum / (lengths_[i] * lengths_[i]);
}

}  // namespace contactsim

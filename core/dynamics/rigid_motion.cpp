// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/rigid_motion.hpp"

namespace contactsim {

namespace {

/// Where a body's arms point now [3 x nodes] [length].
Eigen::Matrix3Xd arms_of(const RigidBody& body, const Eigen::Quaterniond& orientation) {
  return orientation.toRotationMatrix() * body.arms;
}

void sum_forces(const RigidBody& body, const State& state, RigidBodyState& moving) {
  moving.force.setZero();
  moving.moment.setZero();
  for (const NodeIndex node : body.nodes) {
    const Eigen::Vector3d force = state.forces.at(node.value);
    const Eigen::Vector3d arm = state.coordinates.col(node.value) - moving.position;
    moving.force += force;
    moving.moment += arm.cross(force);
    if (state.rotations.exist()) moving.moment += state.rotations.moments.at(node.value);
  }
}

/// The bodies' numbers side by side, as conditions see nodes.
struct BodyArrays {
  Eigen::Matrix3Xd position, velocity, acceleration, angle, turning, angular_acceleration;

  explicit BodyArrays(const std::vector<RigidBodyState>& bodies) {
    const auto n = static_cast<Eigen::Index>(bodies.size());
    for (Eigen::Matrix3Xd* array :
         {&position, &velocity, &acceleration, &angle, &turning, &angular_acceleration})
      array->resize(3, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const RigidBodyState& body = bodies[static_cast<std::size_t>(i)];
      position.col(i) = body.position;
      velocity.col(i) = body.before.velocity;
      acceleration.col(i) = body.acceleration;
      angle.col(i) = body.angle;
      turning.col(i) = body.before.turning;
      angular_acceleration.col(i) = body.angular_acceleration;
    }
  }

  BetweenSteps moves(const State& state) const {
    return {state.time, state.dt, state.next_dt, position, velocity};
  }
  BetweenSteps turns(const State& state) const {
    return {state.time, state.dt, state.next_dt, position, turning, &angle};
  }
};

/// How conditions change angular accelerations: constrained = free acceleration + prescribed.
struct TurningConstraint {
  std::vector<Eigen::Matrix3d> free;  ///< projections
  Eigen::Matrix3Xd prescribed;

  TurningConstraint(const KinematicConstraints& kinematic_constraints, const BetweenSteps& now,
                    Eigen::Index n)
      : free(static_cast<std::size_t>(n)), prescribed(Eigen::Matrix3Xd::Zero(3, n)) {
    kinematic_constraints.constrain(now, prescribed);
    for (Eigen::Index c = 0; c < 3; ++c) {
      Eigen::Matrix3Xd unit = Eigen::Matrix3Xd::Zero(3, n);
      unit.row(c).setOnes();
      kinematic_constraints.constrain(now, unit);
      for (Eigen::Index i = 0; i < n; ++i)
        free[static_cast<std::size_t>(i)].col(c) = unit.col(i) - prescribed.col(i);
    }
  }
};

double half_steps(const State& state) { return 0.5 * (state.dt + state.next_dt); }

/// Translation of all bodies in the coming step.
void drive_places(const Model& model, State& state) {
  for (std::size_t i = 0; i < state.rigid.size(); ++i)
    state.rigid[i].acceleration = state.rigid[i].force / model.rigid.bodies[i].mass;
  BodyArrays arrays(state.rigid);
  model.rigid.kinematic_constraints.constrain(arrays.moves(state), arrays.acceleration);
  for (std::size_t i = 0; i < state.rigid.size(); ++i) {
    RigidBodyState& body = state.rigid[i];
    body.acceleration = arrays.acceleration.col(static_cast<Eigen::Index>(i));
    body.reaction = model.rigid.bodies[i].mass * body.acceleration - body.force;
    body.after.velocity = body.before.velocity + half_steps(state) * body.acceleration;
    body.now.velocity = body.before.velocity + 0.5 * state.dt * body.acceleration;
  }
}

/// Rotation of all bodies in the coming step.
void drive_turns(const Model& model, State& state) {
  const double half = half_steps(state);
  const BodyArrays arrays(state.rigid);
  const TurningConstraint constraint(model.rigid.rotation_constraints, arrays.turns(state),
                                     arrays.position.cols());
  for (std::size_t i = 0; i < state.rigid.size(); ++i) {
    RigidBodyState& body = state.rigid[i];
    const RigidBody& fixed = model.rigid.bodies[i];
    const Eigen::Vector3d spin = body.before.spin + half * body.moment;
    const Eigen::Matrix3d& free = constraint.free[i];
    body.after.spin = spin;
    if (free.isIdentity(1e-9)) {
      body.after.turning = turning_of(fixed, body.orientation, spin, state.next_dt);
    } else {
      const Eigen::Vector3d given = (Eigen::Matrix3d::Identity() - free) * body.before.turning +
                                    half * constraint.prescribed.col(static_cast<Eigen::Index>(i));
      body.after.turning = turning_of(fixed, body, spin, state.next_dt, given, free);
      body.after.spin =
          inertia_amid(fixed, body.orientation, body.after.turning, state.next_dt) * body.after.turning;
    }
    body.reaction_moment = (body.after.spin - spin) / half;
    body.angular_acceleration = (body.after.turning - body.before.turning) / half;
    body.now.turning = body.before.turning + 0.5 * state.dt * body.angular_acceleration;
    body.now.spin = body.before.spin + 0.5 * state.dt * (body.moment + body.reaction_moment);
  }
}

/// Accelerations that take the nodes along the chords of the coming step.
void accelerate_nodes(const RigidBody& body, const RigidBodyState& moving, State& state) {
  const double dt = state.next_dt, half = half_steps(state);
  const Eigen::Quaterniond there = turn_by(dt * moving.after.turning) * moving.orientation;
  const Eigen::Matrix3Xd arms = arms_of(body, there);
  const Eigen::Vector3d position = moving.position + dt * moving.after.velocity;
  for (std::size_t k = 0; k < body.nodes.size(); ++k) {
    const auto node = static_cast<Eigen::Index>(body.nodes[k].value);
    const Eigen::Vector3d chord =
        (position + arms.col(static_cast<Eigen::Index>(k)) - state.coordinates.col(node)) / dt;
    state.acceleration.col(node) = (chord - state.velocity.col(node)) / half;
    if (!state.rotations.exist()) continue;
    state.rotations.acceleration.col(node) =
        (moving.after.turning - state.rotations.velocity.col(node)) / half;
  }
}

std::vector<RigidBodyState> bodies_of_mesh(const Model& model) {
  std::vector<RigidBodyState> bodies(model.rigid.bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].position = model.rigid.bodies[i].centre;
  return bodies;
}

/// Conditions that give velocities at the start.
void drive_start(const Model& model, State& state) {
  BodyArrays arrays(state.rigid);
  model.rigid.kinematic_constraints.constrain_velocity(arrays.moves(state), arrays.velocity);
  model.rigid.rotation_constraints.constrain_velocity(arrays.turns(state), arrays.turning);
  for (std::size_t i = 0; i < state.rigid.size(); ++i) {
    RigidBodyState& body = state.rigid[i];
    const auto column = static_cast<Eigen::Index>(i);
    body.before.velocity = arrays.velocity.col(column);
    if (arrays.turning.col(column) != body.before.turning) {
      body.before.turning = arrays.turning.col(column);
      body.before.spin = inertia_amid(model.rigid.bodies[i], body.orientation, body.before.turning, 0.0) *
                         body.before.turning;
    }
    body.now = body.before;
    set_node_velocities(model.rigid.bodies[i], body, state);
  }
}

}  // namespace

void set_node_velocities(const RigidBody& body, const RigidBodyState& moving, State& state) {
  const Eigen::Matrix3Xd arms = arms_of(body, moving.orientation);
  for (std::size_t k = 0; k < body.nodes.size(); ++k) {
    const auto node = static_cast<Eigen::Index>(body.nodes[k].value);
    const Eigen::Vector3d arm = arms.col(static_cast<Eigen::Index>(k));
    state.velocity.col(node) = moving.now.velocity + moving.now.turning.cross(arm);
    if (state.rotations.exist()) state.rotations.velocity.col(node) = moving.now.turning;
  }
}

void start_rigid_bodies(const Model& model, State& state) {
  if (state.rigid.empty()) state.rigid = bodies_of_mesh(model);
  for (std::size_t i = 0; i < state.rigid.size(); ++i) {
    const RigidBody& body = model.rigid.bodies[i];
    RigidBodyState& moving = state.rigid[i];
    const Eigen::Matrix3Xd arms = arms_of(body, moving.orientation);
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero(), spin = momentum;
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    double mass = 0.0;
    for (std::size_t k = 0; k < body.nodes.size(); ++k) {
      const auto node = static_cast<Eigen::Index>(body.nodes[k].value);
      const double node_mass = model.mass(node);
      const Eigen::Vector3d arm = arms.col(static_cast<Eigen::Index>(k)), v = state.velocity.col(node);
      mass += node_mass;
      momentum += node_mass * v;
      spin += node_mass * arm.cross(v);
      second += node_mass * arm * arm.transpose();
    }
    const Eigen::Matrix3d inertia = second.trace() * Eigen::Matrix3d::Identity() - second;
    moving.before.velocity = momentum / mass;
    moving.before.turning = inverse_where_it_is(inertia) * spin;
    moving.before.spin =
        inertia_amid(body, moving.orientation, moving.before.turning, 0.0) * moving.before.turning;
    moving.now = moving.before;
    set_node_velocities(body, moving, state);
  }
}

void move_rigid_bodies(const Model& model, State& state) {
  for (std::size_t i = 0; i < state.rigid.size(); ++i) {
    const RigidBody& body = model.rigid.bodies[i];
    RigidBodyState& moving = state.rigid[i];
    moving.position += state.dt * moving.after.velocity;
    moving.orientation = (turn_by(state.dt * moving.after.turning) * moving.orientation).normalized();
    moving.angle += state.dt * moving.after.turning;
    moving.before = moving.after;
    const Eigen::Matrix3Xd arms = arms_of(body, moving.orientation);
    for (std::size_t k = 0; k < body.nodes.size(); ++k)
      state.coordinates.col(body.nodes[k].value) = moving.position + arms.col(static_cast<Eigen::Index>(k));
  }
}

void drive_rigid_bodies(const Model& model, State& state) {
  if (state.step == 0) drive_start(model, state);
  for (std::size_t i = 0; i < state.rigid.size(); ++i)
    sum_forces(model.rigid.bodies[i], state, state.rigid[i]);
  drive_places(model, state);
  drive_turns(model, state);
  for (std::size_t i = 0; i < state.rigid.size(); ++i)
    accelerate_nodes(model.rigid.bodies[i], state.rigid[i], state);
}

void add_rigid_balance(const Model& model, const State& state, EnergyBalance& balance) {
  const double half_before = 0.5 * state.dt, half_after = 0.5 * state.next_dt;
  for (std::size_t i = 0; i < state.rigid.size(); ++i) {
    const RigidBodyState& body = state.rigid[i];
    const double mass = model.rigid.bodies[i].mass;
    // Before the first step the leapfrog stands mirrored, as if it had come with the step that follows.
    RigidBodyState::Motion behind = body.before;
    if (state.dt == 0.0) {
      behind = {2.0 * body.now.velocity - body.after.velocity, 2.0 * body.now.turning - body.after.turning,
                2.0 * body.now.spin - body.after.spin};
    }
    balance.kinetic += 0.5 * (mass * body.now.velocity.squaredNorm() + body.now.spin.dot(body.now.turning));
    balance.conserved +=
        0.5 * (mass * body.after.velocity.dot(behind.velocity) +
               0.5 * (body.after.spin.dot(behind.turning) + behind.spin.dot(body.after.turning)));
    balance.momentum += mass * body.now.velocity;
    balance.ended.external += half_before * (body.reaction.dot(body.before.velocity) +
                                             body.reaction_moment.dot(body.before.turning));
    balance.begun.external +=
        half_after * (body.reaction.dot(body.after.velocity) + body.reaction_moment.dot(body.after.turning));
  }
}

}  // namespace contactsim

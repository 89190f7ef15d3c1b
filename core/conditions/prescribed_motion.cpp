// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/prescribed_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/threads.hpp"

namespace contactsim {

namespace {

/// The time of the value that decides about the coming step.
double value_time(MotionType type, const BetweenSteps& now) {
  switch (type) {
    case MotionType::displacement:
      return now.time + now.dt_after;
    case MotionType::velocity:
      return now.time + 0.5 * now.dt_after;
    case MotionType::fixed:
    case MotionType::acceleration:
      break;
  }
  return now.time;
}

/// Calls move(node, value) for every node with the condition's value there. A value that is not finite ends
/// the run after the sweep: nothing may be thrown out of threads.
template <class Move>
void for_each_node(const PrescribedMotion& motion, double time, const NodalFields& fields, const Mesh& mesh,
                   const Move& move) {
  const bool varies = motion.value.varies_in_space();
  const double common = varies ? 0.0 : motion.value.at(time);
  const std::size_t n = motion.nodes.size();
  const std::uint32_t bad = parallel_min(n, threads_for(n), beyond_all_nodes, [&](std::size_t i) {
    const NodeIndex node = motion.nodes[i];
    const double value = varies ? motion.value.at(time, fields, node) : common;
    move(static_cast<Eigen::Index>(node.value), value);
    return std::isfinite(value) ? beyond_all_nodes : node.value;
  });
  if (bad == beyond_all_nodes) return;
  motion.value.fail(time, motion.bodies.empty() ? fmt::format("at node {}", mesh.node_id({bad}))
                                                : fmt::format("for the rigid body '{}'", motion.bodies[bad]));
}

/// A node's motion along a unit vector.
struct Along {
  double displacement;  ///< from the mesh [length]
  double velocity;      ///< as in BetweenSteps [length/time]
};

/// Velocity that brings about the value in the coming step.
double wanted_velocity(MotionType type, double value, double displacement, double dt_after) {
  switch (type) {
    case MotionType::displacement:
      return (value - displacement) / dt_after;
    case MotionType::velocity:
      return value;
    case MotionType::fixed:
    case MotionType::acceleration:
      break;
  }
  return 0.0;
}

double wanted_acceleration(MotionType type, double value, const Along& along, const BetweenSteps& now) {
  if (type == MotionType::acceleration) return value;
  const double wanted = wanted_velocity(type, value, along.displacement, now.dt_after);
  return (wanted - along.velocity) / (0.5 * (now.dt_before + now.dt_after));
}

/// Radians by which a node has turned about the axis in the step before, per time; at the start what its
/// velocity means now.
double angular_velocity(const Axis& axis, const Eigen::Vector3d& offset, const Eigen::Vector3d& velocity,
                        double dt_before) {
  if (offset.isZero(0.0)) return 0.0;
  const double circumferential = axis.direction.dot(offset.cross(velocity));
  if (dt_before == 0.0) return circumferential / offset.squaredNorm();
  const Eigen::Vector3d before = offset - dt_before * velocity;
  return std::atan2(dt_before * circumferential, before.dot(offset)) / dt_before;
}

/// Moves nodes about an axis.
class Turning {
 public:
  Turning(const PrescribedMotion& motion, const Axis& axis, const BetweenSteps& now, const Mesh& mesh)
      : type_(motion.type), axis_(axis), now_(now), mesh_(mesh) {}

  /// Velocity at right angles to the axis that moves a node along its arc in the coming step.
  Eigen::Vector3d wanted_velocity(Eigen::Index i, double value, const Eigen::Vector3d& velocity) const {
    const Eigen::Vector3d offset = axis_.offset_of(now_.coordinates.col(i));
    if (type_ == MotionType::displacement) {
      const Eigen::Vector3d origin = axis_.offset_of(mesh_.coordinates().col(i));
      return (origin - offset + turn(origin, value)) / now_.dt_after;
    }
    double rate = value;
    if (type_ == MotionType::acceleration) {
      rate = angular_velocity(axis_, offset, velocity, now_.dt_before) +
             0.5 * (now_.dt_before + now_.dt_after) * value;
    }
    return turn(offset, rate * now_.dt_after) / now_.dt_after;
  }

 private:
  Eigen::Vector3d turn(const Eigen::Vector3d& offset, double angle) const {
    const double half = std::sin(0.5 * angle);
    return axis_.turn(offset, std::sin(angle), -2.0 * half * half);
  }

  MotionType type_;
  const Axis& axis_;
  const BetweenSteps& now_;
  const Mesh& mesh_;
};

Eigen::Vector3d in_plane(const Axis& axis, const Eigen::Vector3d& vector) {
  return vector - vector.dot(axis.direction) * axis.direction;
}

}  // namespace

void PrescribedMotion::set_acceleration(const BetweenSteps& now, const Mesh& mesh,
                                        Eigen::Matrix3Xd& acceleration) const {
  const double time = value_time(type, now);
  const NodalFields fields{mesh.coordinates(), now.coordinates, now.velocity};
  const Eigen::Matrix3Xd& model = mesh.coordinates();
  if (const auto* components = std::get_if<Components>(&direction)) {
    for_each_node(*this, time, fields, mesh, [&](Eigen::Index i, double wanted) {
      for (Eigen::Index c = 0; c < 3; ++c) {
        if (!components->is_set[static_cast<std::size_t>(c)]) continue;
        const Along along{now.displacement(model, c, i), now.velocity(c, i)};
        acceleration(c, i) = wanted_acceleration(type, wanted, along, now);
      }
    });
  } else if (const auto* unit = std::get_if<Eigen::Vector3d>(&direction)) {
    for_each_node(*this, time, fields, mesh, [&](Eigen::Index i, double wanted) {
      const Along along{unit->dot(now.displacement(model, i)), unit->dot(now.velocity.col(i))};
      const double change = wanted_acceleration(type, wanted, along, now) - unit->dot(acceleration.col(i));
      acceleration.col(i) += change * *unit;
    });
  } else {
    const Axis& axis = std::get<Axis>(direction);
    const Turning turning(*this, axis, now, mesh);
    const double half_steps = 0.5 * (now.dt_before + now.dt_after);
    for_each_node(*this, time, fields, mesh, [&](Eigen::Index i, double wanted) {
      const Eigen::Vector3d velocity = in_plane(axis, now.velocity.col(i));
      const Eigen::Vector3d change = (turning.wanted_velocity(i, wanted, velocity) - velocity) / half_steps;
      acceleration.col(i) += change - in_plane(axis, acceleration.col(i));
    });
  }
}

void PrescribedMotion::set_velocity(const BetweenSteps& now, const Mesh& mesh,
                                    Eigen::Matrix3Xd& velocity) const {
  if (type == MotionType::acceleration) return;
  const double time = type == MotionType::displacement ? value_time(type, now) : now.time;
  const NodalFields fields{mesh.coordinates(), now.coordinates, now.velocity};
  const auto* axis = std::get_if<Axis>(&direction);
  if (axis == nullptr) {
    const std::vector<Eigen::Vector3d> units = unit_vectors(direction);
    for_each_node(*this, time, fields, mesh, [&](Eigen::Index i, double wanted) {
      const Eigen::Vector3d displacement = now.displacement(mesh.coordinates(), i);
      for (const Eigen::Vector3d& unit : units) {
        const double along = wanted_velocity(type, wanted, unit.dot(displacement), now.dt_after);
        velocity.col(i) += (along - unit.dot(velocity.col(i))) * unit;
      }
    });
    return;
  }
  const Turning turning(*this, *axis, now, mesh);
  for_each_node(*this, time, fields, mesh, [&](Eigen::Index i, double wanted) {
    const Eigen::Vector3d turned =
        type == MotionType::displacement
            ? turning.wanted_velocity(i, wanted, Eigen::Vector3d::Zero())
            : Eigen::Vector3d(wanted * axis->direction.cross(axis->offset_of(now.coordinates.col(i))));
    velocity.col(i) += turned - in_plane(*axis, velocity.col(i));
  });
}

}  // namespace contactsim

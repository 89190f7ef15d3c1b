// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/cohesive_traction.hpp"

#include <algorithm>

#include "contact/interface_laws/friction.hpp"

namespace contactsim {

namespace {

/// What a law does at some area before a gap.
struct Pull {
  double force = 0.0;      ///< towards each other [force]
  double potential = 0.0;  ///< [energy]
};

Pull pull_at(const InterfaceLaw& law, double gap, double area) {
  if (!law.pull || gap > law.pull->last()) return {};
  const double apart = std::max(gap, 0.0);
  return {gap >= 0.0 ? law.pull->at(gap) * area : 0.0,
          (law.pull->integral(apart) - law.pull->integral(law.pull->last())) * area};
}

/// Adds the force along the surface of a junction.
///   stiffness  of the tangential spring [force/length]
///   area       at gaps below the cutoff [length^2]
///   velocity   of the first side along the second [length/time]
void add_junction(const RateLimit& law, double stiffness, double area, const Eigen::Vector3d& velocity,
                  ContactPoint& point) {
  const double speed = (velocity - point.normal.dot(velocity) * point.normal).norm();
  const double limit = std::max(law.scale * law.traction.evaluate(speed), 0.0) * area;
  add_friction(stiffness, limit, point);
}

/// Sums over the points of two faces that feel a law.
struct FaceSums {
  double force = 0.0, work = 0.0, potential = 0.0;
  double area = 0.0, area_apart = 0.0, area_held = 0.0;
  double weight = 0.0;
  Eigen::Vector4d weights_1 = Eigen::Vector4d::Zero(), weights_2 = Eigen::Vector4d::Zero();
};

void add_point(const InterfaceLaw& law, double area, double gap, FaceSums& sums) {
  const Pull pull = pull_at(law, gap, area);
  sums.force += pull.force;
  sums.work += pull.force * gap;
  sums.potential += pull.potential;
  sums.area += area;
  if (gap > 0.0) sums.area_apart += area;
  const bool is_held = law.rate_limit && gap < law.rate_limit->cutoff;
  if (is_held) sums.area_held += area;
}

/// Sums over the points that are near enough and not of another wall.
FaceSums sum_points(const InterfaceLaw& law, const FacePenaltyInput& push, const OverlapPoints& points) {
  FaceSums sums;
  for (const OverlapBatch& batch : points.batches()) {
    for (int lane = 0; lane < n_lanes; ++lane) {
      const double area = batch.weight(lane), gap = batch.gap(lane);
      if (!(area > 0.0) || gap >= law.activation_distance() || gap < -push.penalty.depth) continue;
      add_point(law, area, gap, sums);
      // One contact point has one centre of force. What acts along the surface acts at the middle of the
      // area.
      const double weight = law.rate_limit ? area : pull_at(law, gap, area).force;
      sums.weight += weight;
      sums.weights_1 += weight * corner_weights(batch.xi_1(lane), batch.eta_1(lane), push.first.is_triangle);
      sums.weights_2 += weight * corner_weights(batch.xi_2(lane), batch.eta_2(lane), push.second.is_triangle);
    }
  }
  return sums;
}

}  // namespace

void add_node_traction(const InterfaceLaw& law, const NodePenaltyInput& push, ContactPoint& point) {
  if (point.gap >= law.activation_distance()) return;
  const Pull pull = pull_at(law, point.gap, push.area);
  point.is_held_apart = true;
  point.beyond_spring += pull.potential;
  if (point.gap >= 0.0) {
    point.area = push.area;
    point.force = -pull.force;
    point.beyond_spring -= 0.5 * pull.force * point.gap;
  }
  if (law.pull) point.stiffness += law.pull->steepest() * push.area;
  if (!law.rate_limit || point.gap >= law.rate_limit->cutoff) return;
  point.slip = push.last_velocity * push.dt;
  add_junction(*law.rate_limit, push.penalty.stiffness * push.area, push.area, push.last_velocity, point);
}

bool add_face_traction(const InterfaceLaw& law, const FacePenaltyInput& push, ContactPoint& point) {
  const auto found = find_face_face_points(push.first, push.second);
  if (!found) return false;
  const FaceSums sums = sum_points(law, push, found->points);
  if (!(sums.area > 0.0)) return false;
  point.normal = found->plane.normal;
  if (sums.weight != 0.0) {
    point.first.weights = sums.weights_1 / sums.weight;
    point.second.weights = sums.weights_2 / sums.weight;
  }
  point.force = -sums.force;
  point.gap = sums.force != 0.0 ? sums.work / sums.force : 0.0;
  point.area = sums.area_apart;
  point.is_held_apart = true;
  point.beyond_spring = sums.potential - 0.5 * sums.work;
  if (law.pull) point.stiffness = law.pull->steepest() * sums.area;
  if (!law.rate_limit || sums.area_held == 0.0) return true;
  const Eigen::Vector3d velocity = push.first.v * point.first.weights - push.second.v * point.second.weights;
  point.slip = velocity * push.dt;
  const double spring = push.penalty.stiffness * sums.area_held;
  point.stiffness += spring;
  add_junction(*law.rate_limit, spring, sums.area_held, velocity, point);
  return true;
}

}  // namespace contactsim

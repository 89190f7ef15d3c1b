// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "core/base/contact_indices.hpp"

namespace contactsim {

/// One side of a contact point: up to four contact nodes and their shares in the force.
struct ContactPointSide {
  /// Shares of nodes: not aligned, so that a contact point has no gaps.
  using Weights = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;

  std::array<ContactNodeIndex, 4> nodes{};
  Weights weights = Weights::Zero();  ///< sum 1; all 0 of a rigid side [1]
  double radius = 0.0;  ///< by which the point stands off the nodes, towards the other side [length]

  /// Whether it is one node and not a face.
  bool is_node() const { return nodes[0] == nodes[3]; }
};

/// One point where two sides meet in a step: a pair of faces, a node and a face, two edges, a tied point.
struct ContactPoint {
  PairIndex pair;
  std::uint32_t first_entity = 0;   ///< face, surface node or edge
  std::uint32_t second_entity = 0;  ///< face or edge
  bool is_of_edges = false;
  bool is_swapped = false;     ///< the first side is of the pair's second surface
  bool is_held_apart = false;  ///< a law acts on it whether it touches or not
  bool is_balanced = false;    ///< its force comes from the balance of momentum, not from its gap
  bool knows_work = false;     ///< work_before and work_after are those of its whole force
  bool pulls = false;          ///< it has touched and may not part: a gap pulls
  std::uint8_t part = 0;       ///< of several contact points between the same entities

  // What is read and written when forces are known already, close together.
  double force = 0.0;        ///< along the normal on the first side; < 0 where a tie pulls [force]
  double area = 0.0;         ///< that touches [length^2]
  double gap = 0.0;          ///< < 0 when they touch [length]
  double closing = 0.0;      ///< by which the gap would shrink in the coming step, is_balanced only [length]
  double impact = 0.0;       ///< where sides met without rebound, in the step [energy]
  double work_before = 0.0;  ///< taken from the bodies in the half step before [energy]
  double work_after = 0.0;   ///< the same in the half step to come [energy]

  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, from the second side to the first [1]
  ContactPointSide first, second;
  double stiffness = 0.0;  ///< for the stable step, damping included [force/length]
  double begin_gap = 0.0;  ///< at which the pressure begins, from where `gap` counts [length]
  double deepest = 0.0;    ///< penetration of any of its points, of the penalty only [length]
  Eigen::Vector3d tangential = Eigen::Vector3d::Zero();    ///< on the first side [force]
  Eigen::Vector3d elastic_slip = Eigen::Vector3d::Zero();  ///< slip that the tangential spring holds [length]
  Eigen::Vector3d slip = Eigen::Vector3d::Zero();          ///< lost in the step [length]
  double dissipated = 0.0;                                 ///< by friction in the step [energy]
  double damped = 0.0;                                     ///< by contact damping in the step [energy]
  double beyond_spring = 0.0;  ///< stored besides what springs would store [energy]

  /// Whether its first side is a node that meets a face, not a plane.
  bool is_of_node_and_face() const { return first.is_node() && !is_of_edges && !second.weights.isZero(0.0); }
  /// Its entities by what they are.
  FaceIndex first_face() const { return {first_entity}; }
  FaceIndex second_face() const { return {second_entity}; }
  SurfaceNodeIndex row() const { return {first_entity}; }
  EdgeIndex first_edge() const { return {first_entity}; }
  EdgeIndex second_edge() const { return {second_entity}; }

  bool touches() const { return force != 0.0 || is_held_apart; }
  /// Whether it touches, or would at the end of the coming step without a force.
  bool is_met() const { return touches() || pulls || (is_balanced && gap < closing); }
  /// The gap of the sides, wherever their pressure begins [length].
  double open_gap() const { return gap + begin_gap; }
  Eigen::Vector3d force_on_first() const { return force * normal + tangential; }
  /// Scales the forces, and the energies that go with them.
  void scale_forces(double factor) {
    force *= factor;
    tangential *= factor;
    dissipated *= factor;
    damped *= factor;
    beyond_spring *= factor;
  }
  /// What the springs of the penalty and of friction hold, and the potential of what pulls [energy].
  double stored() const {
    if (is_balanced) return beyond_spring;
    return 0.5 * (tangential.norm() * elastic_slip.norm() - force * gap) + beyond_spring;
  }
};

}  // namespace contactsim

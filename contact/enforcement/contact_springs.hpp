// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/enforcement/contact_detection.hpp"
#include "core/dynamics/model.hpp"
#include "core/statics/static_contact.hpp"

namespace contactsim {

/// What contact points and ties resist small motions with, as springs between nodes of the mesh: points of
/// lofts and of spheres, which stand off their nodes, move with these and turn with them, or with the mid
/// surface around (LoftSpins). That normals turn is left out.
class ContactSprings {
 public:
  /// All must outlive this.
  ContactSprings(const Model& model, const ContactKinematics& kinematics, const PairRules& rules)
      : model_(model), kinematics_(kinematics), rules_(rules) {}

  /// The spring of a contact point that touches along its normal.
  ContactSpring spring_of(const ContactPoint& point) const;
  /// The spring of a weighted gap that presses, with its friction.
  ///   motions  of the contact nodes that it grows and slips by
  ContactSpring spring_of(const WeightedNode& node, std::span<const WeightedGapMotion> motions) const;
  /// Along the surface, as long as a point sticks; what slides resists across the way that it slides by the
  /// force that friction has, and is dragged by more where its gap closes.
  ///   dt           of the step [time]
  ///   holds_limit  the limit of friction is held, whatever presses
  std::optional<ContactSpring> friction_spring_of(const ContactPoint& point, double dt,
                                                  bool holds_limit) const;
  /// Between the sides of a contact point.
  ///   stiffness  symmetric [force/length]
  ContactSpring spring_between(const ContactPoint& point, const Eigen::Matrix3d& stiffness) const;
  ContactSpring spring_of(const Tie& tie) const;
  /// Of another constraint, whose corners count as fastened by springs of their own.
  ContactSpring spring_of(const InterfaceConstraint& constraint) const;

 private:
  void add_corners(const ContactPoint& point, ContactSpring& spring) const;
  void add_corner(std::size_t corner, ContactNodeIndex node, const Eigen::Vector3d& beside,
                  ContactSpring& spring) const;
  void add_turning(std::size_t corner, NodeIndex mesh_node, const Eigen::Vector3d& arm,
                   ContactSpring& spring) const;

  const Model& model_;
  const ContactKinematics& kinematics_;
  const PairRules& rules_;
};

}  // namespace contactsim

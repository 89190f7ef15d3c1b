// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "contact/enforcement/contact_assembler.hpp"
#include "contact/enforcement/contact_setup.hpp"
#include "contact/enforcement/contact_springs.hpp"
#include "contact/search/contact_search.hpp"
#include "core/statics/static_contact.hpp"

namespace contactsim {

/// CONTACT STABILIZATION of load steps. A surface node that stands before a face of the other side as a step
/// begins, at a gap g below the range G, and the point of the face below it push against their relative
/// motion u of the step by
///   f = - s c (T / dt) r (1 - g / G) a (n n . u + t (u - n n . u)),  0 <= g; as g = 0 behind the face
/// with the pair's scale s and tangential fraction t, c a thousandth of the stiffness per area of the
/// elements behind both sides, T / dt the steps of such a size in the time stepping block, a the node's area,
/// n the normal and r the ramp, 1 as the block begins and the remaining fraction as it ends. Nodes, faces and
/// normals are those of the start of the step, so that f is linear in u.
/// Source: Abaqus, Stabilization for general contact in Abaqus/Standard; OptiStruct, CNTSTB.
class ContactStabilization {
 public:
  /// All must outlive this.
  ///   start  the faces before the first step, by whose edges AUTO ranges are
  ContactStabilization(const ContactSetup& setup, const PairRules& rules, const ContactKinematics& start);

  /// Whether some pair asks for it.
  bool is_on() const { return is_on_; }
  /// Finds what is near each other as a step begins.
  ///   kinematics  contact nodes are where the step begins
  void begin_step(ContactKinematics kinematics, const Motion& motion);
  void set_level(const StabilizationLevel& level) { level_ = level; }
  /// Whether something is near and resists.
  bool acts() const { return !points_.empty() && largest_share() > 0.0; }
  /// The largest coefficient of a pair over the stiffness of the elements behind its sides [1].
  double largest_share() const;
  /// Finds the forces of a trial.
  void find_forces(const ContactKinematics& kinematics);
  void add_to(ContactAssembler& assembler) const;
  /// The size of the forces of the last trial [force].
  double force() const;
  void visit_springs(const ContactSprings& springs,
                     const std::function<void(const ContactSpring&)>& take) const;
  /// Contact nodes that resist, each once or more.
  std::vector<ContactNodeIndex> nodes() const;
  /// Ends a step. Returns what the mean of the forces at both its ends has taken from the bodies [energy].
  ///   kinematics  of its end
  double end_step(const ContactKinematics& kinematics);
  /// Contact nodes have other numbers from now on: the forces of the step before are over.
  void forget_forces() { last_.resize(3, 0); }
  ///   n_nodes  of contact now
  void archive(std::size_t n_nodes, StateArchive& saved);

 private:
  /// A node and a face, or a plane, as contact points have them.
  struct Point {
    ContactPoint sides;
    double stiffness = 0.0;                           ///< s c (1 - g / G) a, along the normal [force/length]
    Eigen::Vector3d start = Eigen::Vector3d::Zero();  ///< of the first side from the second [length]
  };
  double factor(const SurfacePair& pair) const;
  void add(const ContactKinematics& kinematics, ContactPoint sides, double gap,
           const PenaltyProperties* other);
  void add_faces(const ContactKinematics& kinematics, const Motion& motion);
  void add_planes(const ContactKinematics& kinematics);
  Eigen::Matrix3d stiffness_now(const Point& point) const;

  ContactSetup setup_;
  const PairRules& rules_;
  bool is_on_ = false;
  IndexedVector<PairIndex, double> ranges_;  // 0 of pairs without [length]
  StabilizationLevel level_;
  std::vector<Point> points_;  // of the step
  Eigen::Matrix3Xd begun_;     // where contact nodes were as the step began [length]
  Eigen::Matrix3Xd last_;      // forces on contact nodes as the last step ended; empty: none [force]
};

}  // namespace contactsim

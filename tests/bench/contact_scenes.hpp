// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "contact/enforcement/contact_force.hpp"
#include "core/definition/contact.hpp"
#include "core/dynamics/internal_force.hpp"
#include "element_scenes.hpp"

/// Bodies in contact, for benchmarks of contact's forces and of whole steps with it.
namespace contactsim::bench {

/// How a scene's one pair of surfaces is held apart.
struct PairSettings {
  ConstraintFormulation formulation = ConstraintFormulation::face_face;
  Enforcement enforcement = Enforcement::momentum_balance;
};

/// Two spheres of one layer of hexahedra, the outer one of which turns about the inner one by a hundredth of
/// an edge a step, as in an impact at a hundredth of the speed of sound. The motion is prescribed; what
/// forces would change of it is thrown away.
class SphereScene {
 public:
  ///   n_faces  about, of each sphere
  ///   touches  everywhere by 0.03 of an edge, or a tenth of an edge apart
  SphereScene(std::int64_t n_faces, bool touches, PairSettings settings);
  SphereScene(const SphereScene&) = delete;
  SphereScene& operator=(const SphereScene&) = delete;

  /// Moves the outer sphere.
  void move();
  /// Everything that contact does in a step.
  void step();
  const ContactForce& force() const { return *force_; }
  double n_faces() const { return n_faces_; }
  double n_nodes() const { return static_cast<double>(force_->contact_mesh().n_nodes()); }
  /// Share of the nodes that contact pushes [1].
  double pushed() const;
  /// Memory that contact has asked for and not given back [bytes].
  double memory() const;

 private:
  double n_faces_;  ///< of both spheres
  Mesh mesh_;
  ContactModel contact_;
  Model model_;
  State state_;
  Eigen::Matrix3Xd forces_;
  Eigen::Matrix3d turn_;
  ContactDefinition definition_;
  double memory_before_;
  std::optional<ContactForce> force_;
};

/// Forces with the time that they take.
class Timed final : public ForceTerm {
 public:
  explicit Timed(ForceTerm& term) : term_(term) {}
  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override;
  std::optional<ForceReport> balance(const State& state, Eigen::Matrix3Xd& forces) override;
  double seconds = 0.0;

 private:
  ForceTerm& term_;
};

/// Whole steps of two cubes of 64 x 64 x 64 elastic hexahedra in impact at 50 m/s, whose meshes do not match.
class ImpactScene {
 public:
  explicit ImpactScene(PairSettings settings);
  ImpactScene(const ImpactScene&) = delete;
  ImpactScene& operator=(const ImpactScene&) = delete;

  void step();
  const Mesh& mesh() const { return mesh_; }
  const ContactForce& force() const { return *force_; }
  /// Seconds in contact since the start.
  double contact_seconds() const { return timed_->seconds; }

 private:
  Mesh mesh_;
  ContactModel contact_;
  Model model_;
  State state_;
  std::optional<InternalForce> internal_;
  ContactDefinition definition_;
  std::optional<ContactForce> force_;
  std::optional<Timed> timed_;
  NoLoads none_;
  TimeStepControl control_ = endless();
};

}  // namespace contactsim::bench

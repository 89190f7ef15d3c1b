// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "contact/moving_surface.hpp"
#include "core/elements/gather.hpp"
#include "core/model.hpp"
#include "core/state.hpp"

namespace contactsim {

/// A share of a contact point that one carrier has: a node of the mesh or a rigid body.
struct CarrierTerm {
  std::uint32_t carrier = 0;
  double weight = 0.0;                            ///< signed: < 0 on the second side [1]
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();  ///< from the carrier to the point [length]
};

/// How the carriers of contact nodes answer to forces over the coming step: by lumped mass and rotary
/// inertia, along the directions that conditions leave free; rigid bodies by their six degrees of freedom. A
/// carrier that is held or driven does not answer at all. Collects the changes of velocity. Source: v(t +
/// dt/2) = v* + (dt_before + dt_after) / 2 M^-1 f, as the integrator moves them.
class NodeMobility {
 public:
  /// Carriers: contact nodes, the first one with each node of the mesh, then rigid bodies.
  ///   state  between two steps, the size of the next one is known
  void begin(const Model& model, const MovingSurface& surface, const State& state);
  /// To be called when the contact nodes are others.
  void forget() { inverse_mass_.clear(); }

  /// Appends the terms of a contact node, those of one rigid body as one.
  ///   beside  from the contact node to the point [length]
  void add_terms(std::uint32_t node, double weight, const Eigen::Vector3d& beside,
                 std::vector<CarrierTerm>& terms) const;

  /// Whether a carrier moves like a mass that nothing holds and that does not turn.
  bool is_plain(std::uint32_t carrier) const { return general_[carrier] == none; }
  /// Change of velocity over force of a plain carrier [time/mass].
  double plain_mobility(std::uint32_t carrier) const { return half_steps_ * inverse_mass_[carrier]; }
  /// The largest change of velocity per force [time/mass].
  double translation_bound(std::uint32_t carrier) const;
  /// The square root of the change of angular velocity about a direction per moment, times its length.
  double turn_root(std::uint32_t carrier, const Eigen::Vector3d& turn) const;
  /// The largest of those for unit length.
  double turn_bound(std::uint32_t carrier) const;

  /// Forces that were pushed before stay in all passes.
  void begin_passes();
  void begin_pass();
  /// The changes of velocity so far [length/time], the fourth number is 0, and of angular velocity [1/time].
  const NodeVector& change(std::uint32_t carrier) const { return changes_[carrier]; }
  Eigen::Vector3d turning(std::uint32_t carrier) const {
    return is_plain(carrier) ? Eigen::Vector3d::Zero() : generals_[general_[carrier]].turning;
  }
  /// Pushes a carrier.
  ///   force, moment  over the coming step [force] [force length]
  void push(std::uint32_t carrier, const Eigen::Vector3d& force, const Eigen::Vector3d& moment);
  void push_plain(std::uint32_t carrier, const Eigen::Vector3d& force) {
    changes_[carrier].head<3>() += plain_mobility(carrier) * force;
  }
  std::size_t n_carriers() const { return general_.size(); }

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  /// A carrier that turns, or that conditions hold along some directions.
  struct General {
    Eigen::Matrix3d translation = Eigen::Matrix3d::Zero();    // velocity per impulse [1/mass]
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();       // angular velocity per angular impulse
    double translation_bound = 0.0, rotation_bound = 0.0;     // of the above
    Eigen::Vector3d turning = Eigen::Vector3d::Zero();        // its change so far [1/time]
    Eigen::Vector3d first_turning = Eigen::Vector3d::Zero();  // before any pass
  };

  bool find_free_directions(const Model& model, const State& state);
  void set_nodes(const Model& model);
  void set_bodies(const Model& model);
  void turn_bodies(const Model& model, const State& state);
  General& make_general(std::uint32_t carrier);

  const MovingSurface* surface_ = nullptr;
  const RigidNodes* rigid_ = nullptr;
  const State* state_ = nullptr;
  std::vector<std::uint32_t> general_;               // [n_carriers] position in generals_, or none
  std::vector<double> inverse_mass_;                 // [n_carriers] of plain ones, 0 of held ones [1/mass]
  std::vector<NodeVector> changes_, first_changes_;  // [n_carriers] of velocity; those before any pass
  std::vector<General> generals_;
  std::array<std::vector<std::uint8_t>, 4> active_;  // conditions, as the directions below are of
  std::vector<FreeDirections> held_, held_turns_, held_bodies_, held_body_turns_;  // ascending
  double half_steps_ = 0.0;                                                        // a force acts for [time]
};

}  // namespace contactsim

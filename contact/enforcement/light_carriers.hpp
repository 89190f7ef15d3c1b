// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/base/optional_index.hpp"

namespace contactsim {

using RigidVector = Eigen::Matrix<double, 6, 1>;  ///< of translation, then of rotation
using RigidMatrix = Eigen::Matrix<double, 6, 6>;

/// How a carrier answers to a force and a moment over the coming step.
struct CarrierMobility {
  Eigen::Matrix3d translation = Eigen::Matrix3d::Zero();  ///< velocity by force [time/mass]
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();     ///< angular velocity by moment
};

/// A share of a constraint's point that a light carrier has.
struct LightShare {
  std::uint32_t light = 0;                        ///< position among the light carriers
  Eigen::Matrix3d weight;                         ///< signed [1]
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();  ///< from the carrier to the point [length]
};

/// What a constraint answers when its point moves.
struct LightAnswer {
  Eigen::Vector3d force, change;  ///< the force then, and by how much that is another one in the pass [force]
  Eigen::Matrix3d rate;   ///< by which the force falls with the velocity of the point [force time/length]
  double stiffest = 0.0;  ///< the largest such rate that the constraint may have
};

/// The motion of light carriers by what a pass changes of the forces on them, found together with these
/// forces. Light is a rigid body that moves or turns far more easily than what it meets, such as a light tool
/// or a plate between two columns. Scaled by row sums alone a pass would change the forces that go through it
/// by no more than the ratio of mobilities.
///
/// With the mobility H of the light carriers, their share R in the points, and the force f(v) that a
/// constraint would have when its point moved by the velocity v besides, Newton's method solves s = sum R^T
/// (f(R H s) - y) for the impulses s, each step by conjugate gradients. That is the projection of a projected
/// gradient method in the metric D + R H R^T instead of D, where D is the softness of what is not light.
/// Source: semi-smooth Newton methods with inexact steps of Qi and Sun, Math. Program. 58 (1993) 353-367, for
/// why it converges.
class LightCarriers {
 public:
  using Answer = std::function<LightAnswer(std::uint32_t row, const Eigen::Vector3d& velocity)>;

  /// Begins a step without light carriers.
  void begin(std::size_t n_carriers);
  bool empty() const { return mobility_.empty(); }
  bool is_light(std::uint32_t carrier) const { return index_[carrier].has_value(); }
  /// Position of a light carrier.
  std::uint32_t of(std::uint32_t carrier) const { return *index_[carrier]; }
  void add(std::uint32_t carrier, const CarrierMobility& mobility);
  /// Adds a constraint; returns its row.
  std::uint32_t add_row(std::span<const LightShare> shares);

  /// Finds the motion of a pass.
  void solve(const Answer& answer);
  /// The velocity of a constraint's point by that motion [length/time].
  Eigen::Vector3d velocity(std::uint32_t row) const { return velocity_of(row, motion_); }

 private:
  struct Row {
    std::uint32_t first_share = 0, n_shares = 0;
  };
  using Vectors = std::vector<RigidVector>;

  std::span<const LightShare> shares_of(std::uint32_t row) const {
    return std::span(shares_).subspan(rows_[row].first_share, rows_[row].n_shares);
  }
  Eigen::Vector3d velocity_of(std::uint32_t row, const Vectors& motion) const;
  void add_force(std::uint32_t row, const Eigen::Vector3d& force, Vectors& sums) const;
  void set_motion();
  double evaluate(const Answer& answer);
  void precondition();
  void multiply(const Vectors& x, Vectors& product) const;
  void find_step();
  double descent_at(double share, const Vectors& start, const Answer& answer, double& error);
  bool go(const Answer& answer, double& error);

  std::vector<OptionalIndex<std::uint32_t>> index_;                   // [n_carriers] among the light ones
  std::vector<RigidMatrix> mobility_, mass_, free_, preconditioner_;  // [n_light]
  std::vector<Row> rows_;
  std::vector<LightShare> shares_;
  std::vector<LightAnswer> answers_;           // [n_rows]
  Vectors impulse_, motion_, missing_, step_;  // s, H s, sum R^T (f - y) - s, Newton's step of s
  Vectors x_, residual_, search_, product_;    // of conjugate gradients
};

}  // namespace contactsim

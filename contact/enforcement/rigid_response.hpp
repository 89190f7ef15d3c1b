// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace contactsim {

using RigidVector = Eigen::Matrix<double, 6, 1>;  ///< of translation, then of rotation
using RigidMatrix = Eigen::Matrix<double, 6, 6>;
/// The velocity of a point by the body's velocity and angular velocity; transposed, the force and moment on
/// the body by the force at the point.
using RigidLever = Eigen::Matrix<double, 3, 6>;

/// The lever of a point that has a share of the body.
///   arm  from the body's centre to the point, times the weight [length]
inline RigidLever rigid_lever(double weight, const Eigen::Vector3d& arm) {
  RigidLever lever;
  lever.leftCols<3>() = weight * Eigen::Matrix3d::Identity();
  lever.rightCols<3>() << 0.0, arm.z(), -arm.y(), -arm.z(), 0.0, arm.x(), arm.y(), -arm.x(), 0.0;
  return lever;
}

/// The motion of a rigid body by what a pass changes of the forces on it, found together with these forces.
/// Scaled by row sums alone, a body that turns or moves far more easily than what it touches, such as a light
/// tool, would let each pass change the forces by next to nothing. With the change of force and moment s, the
/// body's mobility H and the constraints' forces f(H s), Newton's method solves s = sum R^T (f(H s) - y),
/// which is the projection of a projected gradient method in the metric D + R H R^T instead of D.
class RigidResponse {
 public:
  /// Begins a pass.
  ///   mobility  of the body, positive semi-definite
  void begin(const RigidMatrix& mobility);
  /// The velocity and angular velocity that come with the forces so far [length/time, 1/time].
  const RigidVector& velocity() const { return velocity_; }
  /// Adds a constraint's answer to velocity().
  ///   change  of its force on the body [force]
  ///   rate    by which that falls with the velocity of its point [force time/length]
  void add(const RigidLever& lever, const Eigen::Vector3d& change, const Eigen::Matrix3d& rate);
  /// Goes on to the next velocity. Returns whether it stays.
  bool step();

 private:
  RigidMatrix mobility_;
  RigidVector impulse_, velocity_;  // s, H s
  RigidVector answer_;              // sum of R^T change
  RigidMatrix slope_;               // sum of R^T rate R
  double size_ = 0.0;               // of all answers
};

/// The bodies of a step whose motion is found together with the forces on them.
class RigidResponses {
 public:
  void clear() { bodies_.clear(); }
  bool empty() const { return bodies_.empty(); }
  /// Position of a carrier's response; a new one of those that have none.
  std::uint32_t of(std::uint32_t carrier);
  std::size_t size() const { return bodies_.size(); }
  std::uint32_t carrier(std::uint32_t index) const { return bodies_[index].carrier; }
  RigidResponse& operator[](std::uint32_t index) { return bodies_[index].response; }
  const RigidResponse& operator[](std::uint32_t index) const { return bodies_[index].response; }

 private:
  struct Body {
    std::uint32_t carrier = 0;
    RigidResponse response;
  };
  std::vector<Body> bodies_;
};

}  // namespace contactsim

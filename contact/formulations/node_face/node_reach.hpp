// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "contact/formulations/contact_step_context.hpp"
#include "contact/geometry/float_lanes.hpp"
#include "contact/geometry/float_positions.hpp"
#include "core/base/bytes_of.hpp"
#include "core/base/indexed_vector.hpp"

namespace contactsim {

/// Where faces are, a cache line each: enough to see that most candidates are out of a node's reach.
class ReachBounds {
 public:
  /// A face, from an origin near all faces.
  struct alignas(64) Bound {
    Eigen::Vector3f centre;    ///< [length]
    float radius = 0.0f;       ///< of the sphere around the centre [length]
    Eigen::Vector3f normal;    ///< unit [1]
    float spread = 0.0f;       ///< how much faster than their mean a corner moves along it [length/time]
    Eigen::Vector3f velocity;  ///< mean of the corners [length/time]
    float warp = 0.0f;         ///< how far the face is off a parallelogram, at most [length]
    float lean = 0.0f;         ///< of a surface that it stands for [1]
    float thickness = 0.0f;    ///< of its element [length]
    float flush = 0.0f;        ///< by how little what stands beside it may be behind it [length]
    SurfaceIndex surface;
  };

  /// Takes over where faces are, those whose bounds are those of now.
  void update(const ContactStepContext& context);
  /// Finds how far normals may turn while corners move by so much, before NodeReach::find_close().
  ///   motion  [length]
  void find_turns(const ContactKinematics& kinematics, double motion) {
    kinematics.find_turns(motion, turns_);
  }
  float turn(FaceIndex face) const { return turns_[face]; }
  const Bound& operator[](FaceIndex face) const { return bounds_[face]; }
  Eigen::Vector3f position(const Eigen::Vector3d& x) const { return positions_.position(x); }
  /// Of positions in single precision, at most [length].
  float rounding() const { return positions_.rounding(); }
  std::size_t bytes() const { return bytes_of(bounds_) + bytes_of(turns_); }

 private:
  IndexedVector<FaceIndex, Bound> bounds_;
  IndexedVector<FaceIndex, float> turns_;  // [1]
  FloatPositions positions_;
};

/// How far off the faces of one surface a node may touch them. Of faces as nodes know them, says rather too
/// far; what is farther needs no projection.
class NodeReach {
 public:
  /// How far off one face [length].
  struct Limits {
    float above = 0.0f;   ///< before it, along the normal
    float below = 0.0f;   ///< behind it
    float beyond = 0.0f;  ///< beyond its edges
  };
  /// The same of some faces of the surface.
  class Faces {
   public:
    void clear() { n_ = 0; }
    bool are_full() const { return n_ == n_float_lanes; }
    std::size_t size() const { return n_; }
    void add(FaceIndex face) { faces_[n_++] = face; }
    FaceIndex face(std::size_t lane) const { return faces_[lane]; }
    Limits limits(std::size_t lane) const { return {above_[lane], below_[lane], beyond_[lane]}; }

   private:
    friend class NodeReach;
    std::array<FaceIndex, n_float_lanes> faces_;
    std::size_t n_ = 0;
    FloatLanes above_, below_, beyond_;
  };

  ///   is_known  the node touched something in the last step
  NodeReach(const ContactStepContext& context, const ReachBounds& bounds, SurfaceNodeIndex row,
            SurfaceIndex surface, bool is_known);

  PairIndex pair() const { return pair_; }
  const PairRule& rule() const { return *rule_; }
  /// What is taken off the gap, and how much of it by the node's multiplier [length].
  double offset() const { return offset_; }
  double deeper() const { return deeper_; }
  /// Finds the limits of faces. Returns which of them, as bits, the node may touch.
  std::uint32_t find(const ReachBounds& bounds, Faces& faces) const;
  /// Which of them, as bits, the node may touch while it and the corners stay in a range of motion, but
  /// before the first step. The bounds know how normals turn meanwhile.
  std::uint32_t find_close(const ReachBounds& bounds, const Faces& faces, const CloseRange& range) const;

 private:
  Eigen::Vector3f x_, v_;
  float rounding_ = 0.0f;
  PairIndex pair_;
  const PairRule* rule_ = nullptr;
  double offset_ = 0.0, deeper_ = 0.0;
  float dt_ = 0.0f, ahead_ = 0.0f;
  float before_ = 0.0f;     // gaps up to it count however slow sides close [length]
  double thickness_ = 0.0;  // of the node's element [length]
  float radius_ = 0.0f;     // of a sphere [length]
  float shallow_ = 0.0f;    // how deep what touched nothing may be [length]
  std::optional<float> normal_tolerance_, tangential_tolerance_;  // [length]
  bool comes_from_outside_;                                       // it touched nothing, and is no deeper
  bool is_known_, goes_anywhere_;
};

/// Whether what is behind a face must have come through it in the last step. Before the first one there
/// is no motion to decide by: what overlaps then is pushed out. What a ramp brings in comes from in front, in
/// a load step by any depth.
bool must_come_from_outside(const ContactStepContext& context, const PairRule& rule);

}  // namespace contactsim

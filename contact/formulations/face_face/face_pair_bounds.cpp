// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/face_face/face_pair_bounds.hpp"

#include "core/base/threads.hpp"

namespace contactsim {

namespace {

/// Share of lengths and of speeds that single precision may lose: may_touch() of two bounds loses other bits.
constexpr float lost_share = 1e-5f;

}  // namespace

void FacePairBounds::update(const ContactKinematics& kinematics) {
  const auto& faces = kinematics.contact_mesh().faces;
  bounds_.resize(faces.size());
  if (faces.empty()) return;
  positions_.begin(kinematics.x(faces[{0}].corners[0]));
  const auto n = static_cast<std::uint32_t>(kinematics.n_bounded());
  parallel_for(n, threads_for(std::size_t{10} * n), [&](std::uint32_t i) {
    const FaceIndex face = kinematics.bounded(i);
    const FaceBound& bound = kinematics.bound(face);
    bounds_[face] = {positions_.position(bound.centre()),
                     bound.warp(),
                     bound.normal(),
                     bound.velocity(),
                     bound.half(0),
                     bound.half(1)};
  });
  positions_.note_rounding(n, 8.0f, [&](std::uint32_t i) -> const Eigen::Vector3f& {
    return bounds_[kinematics.bounded(i)].centre;
  });
}

/// The bounds of one side of all pairs.
struct FacePairBounds::BoundLanes {
  VectorLanes centre;
  FloatLanes warp;
  VectorLanes normal, velocity;
  std::array<VectorLanes, 2> half;
  std::array<FloatLanes, 2> length;  // of the halves, at least
  FloatLanes size;                   // the radius, at least

  /// Numbers of a bound in its order.
  explicit BoundLanes(const RecordLanes<Bound>& of)
      : centre(of.vector(0)),
        warp(of[3]),
        normal(of.vector(4)),
        velocity(of.vector(7)),
        half{of.vector(10), of.vector(13)},
        length{taxicab(half[0]), taxicab(half[1])},
        size(length[0] + length[1] + warp) {}
  /// How far the parallelogram reaches along a direction.
  FloatLanes reach_along(const VectorLanes& direction) const {
    return magnitude(half[0].dot(direction)) + magnitude(half[1].dot(direction));
  }
};

/// What says that two faces of each lane do not touch.
struct FacePairBounds::Apart {
  VectorLanes apart;    // from the second centre to the first
  FloatLanes distance;  // no less than theirs
  FloatLanes error;     // of single precision [length]
  FloatLanes height;    // of the first over the second
  FloatLanes warp;
  FloatLanes facing;  // cosine of the normals' angle
  FloatLanes tilt;    // how far the normals are from opposite, at least [1]

  Apart(const BoundLanes& a, const BoundLanes& b, float rounding)
      : apart(a.centre - b.centre),
        distance(taxicab(apart)),
        error(rounding + lost_share * (a.size + b.size + distance)),
        height(apart.dot(b.normal)),
        warp(a.warp + b.warp),
        facing(a.normal.dot(b.normal)),
        tilt(taxicab({a.normal.x + b.normal.x, a.normal.y + b.normal.y, a.normal.z + b.normal.z})) {}

  /// Whether faces look the same way, or are farther apart than the activation distance.
  ///   turn  of both normals [1]
  [[gnu::always_inline]] FloatMask are_away(const BoundLanes& a, const BoundLanes& b,
                                            const FloatLanes& activation_distance,
                                            const FloatLanes& turn) const {
    return facing > static_cast<float>(max_facing_cosine_of_blade) + lost_share + turn ||
           (height > activation_distance * (1.0f + lost_share) + a.reach_along(b.normal) + warp + error);
  }
  /// Whether faces are beside each other.
  ///   slack  [length]
  [[gnu::always_inline]] FloatMask are_beside(const BoundLanes& a, const BoundLanes& b,
                                              const FloatLanes& slack) const {
    FloatMask is_out = magnitude(apart.dot(b.half[0])) >
                       a.reach_along(b.half[0]) + b.reach_along(b.half[0]) + slack * b.length[0];
    is_out = is_out || magnitude(apart.dot(a.half[0])) >
                           a.reach_along(a.half[0]) + b.reach_along(a.half[0]) + slack * a.length[0];
    is_out = is_out || magnitude(apart.dot(b.half[1])) >
                           a.reach_along(b.half[1]) + b.reach_along(b.half[1]) + slack * b.length[1];
    return is_out || magnitude(apart.dot(a.half[1])) >
                         a.reach_along(a.half[1]) + b.reach_along(a.half[1]) + slack * a.length[1];
  }
};

inline RecordLanes<FacePairBounds::Bound> FacePairBounds::bounds_of(
    const std::array<FaceIndex, n_float_lanes>& faces, std::size_t n) const {
  RecordLanes<Bound> records;
  records.fill(
      n, [&](std::size_t lane) -> const auto& { return bounds_[faces[lane]]; });
  return records;
}

std::uint32_t FacePairBounds::may_touch(const Pairs& pairs, double ahead, double reach) const {
  const BoundLanes a(bounds_of(pairs.first, pairs.n)), b(bounds_of(pairs.second, pairs.n));
  const Apart sides(a, b, positions_.rounding());
  const VectorLanes velocity = b.velocity - a.velocity;
  const FloatLanes closing = above_zero(velocity.dot(b.normal)) + lost_share * taxicab(velocity);
  const FloatLanes activation_distance = closing * static_cast<float>(ahead) + static_cast<float>(reach);
  // Seen along the common normal instead of the second face's, points move by the tilt.
  const FloatLanes slack =
      sides.warp + sides.tilt * (magnitude(sides.height) + 0.25f * (a.size + b.size)) + sides.error;
  const FloatMask is_out = sides.are_away(a, b, activation_distance, 0.0f) || sides.are_beside(a, b, slack);
  return ~is_out.bits() & pairs.all();
}

/// Corners that have moved by d stay within d of where their face was, so that what parts these wider faces
/// now parts the faces then. What is seen along the common normal depends on how normals turn meanwhile.
std::uint32_t FacePairBounds::may_meet(const Pairs& pairs, const CloseRange& range, double reach) const {
  const BoundLanes a(bounds_of(pairs.first, pairs.n)), b(bounds_of(pairs.second, pairs.n));
  Apart sides(a, b, positions_.rounding());
  FloatLanes::Numbers turns{};
  for (std::size_t lane = 0; lane < pairs.n; ++lane)
    turns[lane] = turns_[pairs.first[lane]] + turns_[pairs.second[lane]];
  const FloatLanes turn(turns), both_move(2.0f * static_cast<float>(range.motion));
  sides.warp += both_move;
  const FloatLanes slack = sides.warp +
                           (sides.tilt + 2.0f * turn) * (magnitude(sides.height) + both_move +
                                                         turn * sides.distance + 0.25f * (a.size + b.size)) +
                           sides.error;
  const FloatLanes activation_distance(static_cast<float>(reach + range.soon));
  const FloatMask is_out = sides.are_away(a, b, activation_distance, turn) || sides.are_beside(a, b, slack);
  return ~is_out.bits() & pairs.all();
}

}  // namespace contactsim

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
  const auto n = static_cast<std::uint32_t>(faces.size());
  bounds_.resize(n);
  if (n == 0) return;
  positions_.begin(kinematics.x(faces[{0}].corners[0]));
  parallel_for(n, threads_for(n), [&](std::uint32_t i) {
    const FaceBound& bound = kinematics.bound({i});
    bounds_[{i}] = {positions_.position(bound.centre()),
                    bound.warp(),
                    bound.normal(),
                    bound.velocity(),
                    bound.half(0),
                    bound.half(1)};
  });
  positions_.note_rounding(n, 8.0f,
                           [&](std::uint32_t i) -> const Eigen::Vector3f& { return bounds_[{i}].centre; });
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

std::uint32_t FacePairBounds::may_touch(const Pairs& pairs, double ahead, double reach) const {
  RecordLanes<Bound> of_first, of_second;
  of_first.fill(
      pairs.n, [&](std::size_t lane) -> const auto& { return bounds_[pairs.first[lane]]; });
  of_second.fill(
      pairs.n, [&](std::size_t lane) -> const auto& { return bounds_[pairs.second[lane]]; });
  const BoundLanes a(of_first), b(of_second);
  const VectorLanes velocity = b.velocity - a.velocity, apart = a.centre - b.centre;
  const FloatLanes error = positions_.rounding() + lost_share * (a.size + b.size + taxicab(apart));
  const FloatLanes closing = above_zero(velocity.dot(b.normal)) + lost_share * taxicab(velocity);
  const FloatLanes height = apart.dot(b.normal), warp = a.warp + b.warp;
  const FloatLanes activation_distance = closing * static_cast<float>(ahead) + static_cast<float>(reach);
  FloatMask is_out =
      a.normal.dot(b.normal) > static_cast<float>(max_facing_cosine_of_blade) + lost_share ||
      (height > activation_distance * (1.0f + lost_share) + a.reach_along(b.normal) + warp + error);
  // Seen along the common normal instead of the second face's, points move by this much.
  const VectorLanes tilt{a.normal.x + b.normal.x, a.normal.y + b.normal.y, a.normal.z + b.normal.z};
  const FloatLanes slack = warp + taxicab(tilt) * (magnitude(height) + 0.25f * (a.size + b.size)) + error;
  for (std::size_t i = 0; i < 2; ++i) {
    is_out = is_out || magnitude(apart.dot(b.half[i])) >
                           a.reach_along(b.half[i]) + b.reach_along(b.half[i]) + slack * b.length[i];
    is_out = is_out || magnitude(apart.dot(a.half[i])) >
                           a.reach_along(a.half[i]) + b.reach_along(a.half[i]) + slack * a.length[i];
  }
  return ~is_out.bits() & pairs.all();
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/node_face/node_reach.hpp"

#include <algorithm>
#include <limits>

#include "contact/formulations/contact_multipliers.hpp"
#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/flush_rims.hpp"
#include "contact/formulations/near_pairs.hpp"
#include "contact/formulations/penalty.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

namespace {

/// Share of lengths that single precision may lose.
constexpr float rounding_share = 4e-6f;

/// A face flatter than this has the normal of its bound, nearly. What closes along others, by what turns in
/// its plane, is far less than the rest of what is allowed.
constexpr float nearly_flat = 0.01f, more = 1.5f;

std::optional<float> to_float(const std::optional<double>& value) {
  return value ? std::optional(static_cast<float>(*value)) : std::nullopt;
}

}  // namespace

void ReachBounds::update(const ContactStepContext& context) {
  const ContactKinematics& now = context.kinematics;
  const auto& faces = now.contact_mesh().faces;
  bounds_.resize(faces.size());
  if (faces.empty()) return;
  positions_.begin(now.x(faces[{0}].corners[0]));
  const auto n = static_cast<std::uint32_t>(now.n_bounded());
  parallel_for(n, threads_for(std::size_t{10} * n), [&](std::uint32_t i) {
    const FaceIndex face = now.bounded(i);
    const FaceBound& bound = now.bound(face);
    bounds_[face] = {position(bound.centre()),
                     bound.radius(),
                     bound.normal(),
                     bound.normal_velocity_spread(),
                     bound.velocity(),
                     bound.warp(),
                     bound.lean(),
                     static_cast<float>(faces[face].penalty_properties.thickness),
                     static_cast<float>(flush_width(context, face)),
                     faces[face].surface};
  });
  positions_.note_rounding(
      n, 8.0f, [&](std::uint32_t i) -> const Eigen::Vector3f& { return bounds_[now.bounded(i)].centre; });
}

NodeReach::NodeReach(const ContactStepContext& context, const ReachBounds& bounds, SurfaceNodeIndex row,
                     SurfaceIndex surface, bool is_known)
    : rounding_(bounds.rounding()),
      dt_(static_cast<float>(context.dt)),
      ahead_(static_cast<float>(context.ahead())),
      is_known_(is_known) {
  const SurfaceNode& node = context.kinematics.contact_mesh().surface_nodes[row];
  x_ = bounds.position(context.kinematics.x(node.node));
  v_ = context.kinematics.v(node.node).cast<float>();
  pair_ = *context.rules.find(node.surface, surface);
  rule_ = &context.rules.of_node(pair_, row);
  deeper_ = context.multipliers ? context.multipliers->value_or(pair_, row, 0.0) : 0.0;
  offset_ = context.rules.gap_offsets().of_node(pair_, row) + rule_->begin_gap + deeper_;
  radius_ = node.radius;
  const double thickness = node.penalty_properties.thickness;
  const double margin = context.balances ? closed_share * thickness : 0.0;
  const double held = is_known ? rule_->pair->held_gap(thickness) : 0.0;
  before_ = static_cast<float>(std::max({rule_->activation_distance, margin, held}));
  thickness_ = thickness;
  shallow_ = static_cast<float>(shallow_depth * thickness);
  normal_tolerance_ = to_float(rule_->pair->normal_tolerance);
  tangential_tolerance_ = to_float(rule_->pair->tangential_tolerance);
  comes_from_outside_ = !is_known && must_come_from_outside(context, *rule_);
  goes_anywhere_ = rule_->pair->behavior == InteractionBehavior::infinitesimal_sliding;
}

std::uint32_t NodeReach::find(const ReachBounds& bounds, Faces& faces) const {
  RecordLanes<ReachBounds::Bound> of;  // the numbers of a bound in its order
  of.fill(
      faces.n_, [&](std::size_t lane) -> const auto& { return bounds[faces.faces_[lane]]; });
  const VectorLanes away = VectorLanes::all(x_) - of.vector(0), normal = of.vector(4),
                    closing = of.vector(8) - VectorLanes::all(v_);
  const FloatLanes radius = of[3], spread = of[7], warp = of[11], lean = of[12], thickness = of[13],
                   flush = of[14];
  const FloatLanes height = away.dot(normal), mean = closing.dot(normal);
  const FloatLanes soonest = above_zero(mean + spread);
  const auto offset = static_cast<float>(offset_);
  const FloatLanes rough = warp + rounding_ + rounding_share * (radius + magnitude(height));
  // Before the first step faces in front of the node count too: it is not inside what it stands in front of.
  FloatLanes near = largest(soonest * ahead_, FloatLanes(before_));
  if (dt_ == 0.0f) near = largest(near, radius);
  faces.above_ = near + (std::max(0.0f, offset) + radius_ + rounding_);
  faces.below_ = std::numeric_limits<float>::max();
  if (!is_known_) {
    const FloatLanes tolerance = normal_tolerance_ ? FloatLanes(*normal_tolerance_) : thickness;
    faces.below_ = largest(tolerance, more * dt_ * above_zero(mean));
    if (comes_from_outside_) {
      const FloatLanes deepest = more * (largest(shallow_, flush) + soonest * dt_);
      const FloatMask is_flat = warp <= nearly_flat * radius && lean == 0.0f;
      const FloatMask is_less = is_flat && deepest < faces.below_;
      faces.below_ = is_less.select(deepest, faces.below_);
    }
    faces.below_ += std::max(0.0f, -offset) + rounding_;
  }
  const FloatLanes allowed = tangential_tolerance_ ? FloatLanes(*tangential_tolerance_)
                                                   : static_cast<float>(automatic_beyond) * radius;
  // Behind the edge of a hollow a node may stand as far beyond it as it is deep.
  faces.beyond_ = allowed + above_zero(warp - height) + (radius_ + rounding_);
  FloatMask is_out = height > faces.above_ + rough || height < -faces.below_ - rough;
  if (!goes_anywhere_) {
    const FloatLanes turned = 2.0f * warp / radius + lean;
    const FloatLanes reach = radius + rough + faces.beyond_ + turned * magnitude(height);
    is_out = is_out || away.dot(away) - height * height > reach * reach * (1.0f + rounding_share);
  }
  return ~is_out.bits() & ((1u << faces.n_) - 1);
}

/// As find(), with all that may have changed at the end of the range: by d each of the node and the corners,
/// so that their distance is by 2 d, the warp by d, the radius by 2 d, and by the turn of the normal.
std::uint32_t NodeReach::find_close(const ReachBounds& bounds, const Faces& faces,
                                    const CloseRange& range) const {
  RecordLanes<ReachBounds::Bound> of;
  of.fill(
      faces.n_, [&](std::size_t lane) -> const auto& { return bounds[faces.faces_[lane]]; });
  FloatLanes::Numbers turns{};
  for (std::size_t lane = 0; lane < faces.n_; ++lane) turns[lane] = bounds.turn(faces.faces_[lane]);
  const auto d = static_cast<float>(range.motion);
  const VectorLanes away = VectorLanes::all(x_) - of.vector(0), normal = of.vector(4);
  const FloatLanes radius = of[3] + 2.0f * d, least_radius = of[3] - 2.0f * d, warp = of[11] + d,
                   lean = of[12];
  const FloatLanes height = away.dot(normal), distance = taxicab(away);
  const FloatLanes moved = 2.0f * d + FloatLanes(turns) * distance;
  const FloatLanes rough = warp + rounding_ + rounding_share * (radius + magnitude(height) + moved) * 2.0f;
  const auto soon = static_cast<float>(range.soon), reach = static_cast<float>(range.reach);
  // However the pair is enforced then, and whatever the node touches.
  const auto before = static_cast<float>(
      std::max({rule_->activation_distance, closed_share * thickness_, rule_->pair->held_gap(thickness_)}));
  const float above = before + soon + reach + radius_ + rounding_;
  FloatMask is_out = height > above * (1.0f + rounding_share) + moved + rough;
  if (!goes_anywhere_) {
    const FloatLanes allowed = tangential_tolerance_ ? FloatLanes(*tangential_tolerance_)
                                                     : static_cast<float>(automatic_beyond) * radius;
    const FloatLanes beyond = allowed + above_zero(warp - height + moved) + (radius_ + rounding_);
    const FloatLanes turned = 2.0f * warp / least_radius + lean;
    const FloatLanes aside = radius + rough + beyond + turned * (magnitude(height) + moved) + moved;
    const FloatMask is_beside = least_radius > 0.0f && away.dot(away) - height * height >
                                                           aside * aside * (1.0f + 4.0f * rounding_share);
    is_out = is_out || is_beside;
  }
  return ~is_out.bits() & ((1u << faces.n_) - 1);
}

bool must_come_from_outside(const ContactStepContext& context, const PairRule& rule) {
  return context.dt > 0.0 && !(context.is_static && rule.pair->gap.overlap_ramp_time);
}

}  // namespace contactsim

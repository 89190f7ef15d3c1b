// SPDX-License-Identifier: BSD-3-Clause
// How far off a face a node may touch it: what is farther needs no projection.
#include <algorithm>

#include "contact/formulations/contact_multipliers.hpp"
#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/flush_rims.hpp"
#include "contact/formulations/node_face/near_faces.hpp"
#include "contact/formulations/penalty.hpp"

namespace contactsim {

NodeFaceContacts::Reach NodeFaceContacts::find_reach(const ContactStepContext& context,
                                                     const NodeAndFace& pair, bool is_known) const {
  const auto& [row, node, face_index, face, bound, rule, x] = pair;
  Reach reach;
  const Eigen::Vector3f closing = bound.velocity() - context.kinematics.v(node.node).cast<float>();
  const float mean = closing.dot(bound.normal());
  const double soonest = above_zero(mean + bound.normal_velocity_spread());
  const double thinner = std::min(face.penalty_properties.thickness, node.penalty_properties.thickness);
  const double margin = context.balances ? closed_share * thinner : 0.0;
  reach.closed = above_zero(mean) * context.dt;
  reach.near = soonest * context.ahead();
  // Before the first step faces in front of the node count too: it is not inside what it stands in front of.
  reach.from_afar = std::max({rule.activation_distance, margin,
                              context.dt > 0.0 ? reach.near : std::max<double>(reach.near, bound.radius())});
  reach.near = std::max(reach.near, margin);
  reach.held = is_known ? rule.pair->held_gap(thinner) : 0.0;
  const PairIndex index = *context.rules.find(node.surface, face.surface);
  reach.deeper = context.multipliers ? context.multipliers->value_or(index, row, 0.0) : 0.0;
  reach.offset = context.rules.gap_offsets().of_node(index, row) + rule.begin_gap + reach.deeper;
  reach.deepest = std::max({rule.pair->normal_tolerance.value_or(face.penalty_properties.thickness),
                            1.5 * reach.closed, is_known ? any_depth : 0.0});
  if (!is_known && must_come_from_outside(context, rule))
    reach.deepest = std::min(reach.deepest, deepest_of_unknown(context, pair, soonest * context.dt));
  // Behind the edge of a hollow a node may stand as far beyond it as it is deep.
  const double behind = std::max(0.0f, bound.warp() - bound.height_of(x));
  reach.beyond = allowed_beyond(*rule.pair, bound) + behind;
  return reach;
}

/// Before the first step nobody knows where nodes come from; what overlaps then is pushed out. What a ramp
/// brings in comes from in front, in a load step by any depth.
bool NodeFaceContacts::must_come_from_outside(const ContactStepContext& context, const PairRule& rule) {
  return context.dt > 0.0 && !(context.is_static && rule.pair->gap.overlap_ramp_time);
}

/// How deep a node that touched nothing may be for comes_from_outside(), rather too much: points of a warped
/// face close along other normals than that of its bound.
///   closed  by which they have closed in the last step, at most [length]
double NodeFaceContacts::deepest_of_unknown(const ContactStepContext& context, const NodeAndFace& pair,
                                            double closed) {
  constexpr double nearly_flat = 0.01, more = 1.5;
  if (pair.bound.warp() > nearly_flat * pair.bound.radius() || pair.bound.lean() > 0.0f) return any_depth;
  const double shallow =
      std::max(shallow_depth * pair.node.penalty_properties.thickness, flush_width(context, pair.face_index));
  return more * (shallow + closed);
}

}  // namespace contactsim

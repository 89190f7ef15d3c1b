// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/edge_edge/edge_edge_contacts.hpp"

#include <algorithm>
#include <limits>

#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/penalty.hpp"
#include "contact/formulations/prefetch.hpp"
#include "contact/interface_laws/friction.hpp"
#include "contact/mesh/feature_edges.hpp"

namespace contactsim {

namespace {

/// Nearer than this share to an end of an edge a point is at the end.
constexpr double at_end = 1e-9;

/// How deep edges may be before they back up nodes, over the thinner side: nodes come first.
constexpr double left_to_nodes = 0.02;

/// What make_contact_point() leaves of pairs of sharp edges that have touched nothing. Before the first step
/// they may be as deep as an element is thick.
EdgeBounds::Reach reach_of_untouched(const ContactStepContext& context) {
  const double shift = context.rules.largest_shift();
  if (!(context.dt > 0.0)) return {context.ahead(), shift, 1.0};
  return {context.ahead() + context.dt, shift, std::max(shallow_depth + left_to_nodes, closed_share)};
}

bool is_inside(double share) { return share > at_end && share < 1.0 - at_end; }

Segment segment_of(const ContactKinematics& kinematics, const ContactEdge& edge) {
  Segment segment;
  segment << kinematics.x(edge.nodes[0]), kinematics.x(edge.nodes[1]);
  return segment;
}

ContactPointSide side_of(const ContactEdge& edge, double share) {
  return {{edge.nodes[0], edge.nodes[1], edge.nodes[1], edge.nodes[1]},
          {1.0 - share, share, 0.0, 0.0},
          edge.radius_at(share)};
}

/// The velocity of the surface of an edge at a point.
///   arm  from the axis to the surface [length]
Eigen::Vector3d velocity_at(const ContactKinematics& kinematics, const ContactPointSide& side,
                            const Eigen::Vector3d& arm) {
  return side.weights[0] * kinematics.velocity_beside(side.nodes[0], arm) +
         side.weights[1] * kinematics.velocity_beside(side.nodes[1], arm);
}

/// Whether a point is farther than this from both ends of an edge, where flush rims cross.
bool is_off_ends(const ContactKinematics& kinematics, const ContactEdge& edge, double share,
                 double distance) {
  const double length = (kinematics.x(edge.nodes[1]) - kinematics.x(edge.nodes[0])).norm();
  return std::min(share, 1.0 - share) * length > distance;
}

/// Whether the edges of a pair stop what nodes on faces do not: the part of a face that hangs over an edge of
/// the other side, away from all nodes. Where gaps are not those of the mesh, they know none of their own.
bool backs_up_nodes(const PairRule& rule) {
  const SurfacePair& pair = *rule.pair;
  return rule.is_balanced && pair.formulation == ConstraintFormulation::node_face &&
         pair.behavior != InteractionBehavior::infinitesimal_sliding && !pair.gap.needs_start();
}

}  // namespace

bool EdgeEdgeContacts::owns(const ContactStepContext& context, EdgeIndex index, double share,
                            const EdgePairPoint& pair_point, const Eigen::Vector3d& way) const {
  constexpr double alike = 1e-6;  // cosine of directions that count as square to the way
  const ContactEdge& edge = contact_mesh_.edges[index];
  if (edge.is_sharp() || edge.is_particle() || (share > 0.0 && share < 1.0) || pair_point.length > 0.0)
    return true;
  const ContactNodeIndex node = contact_mesh_.first_alike[edge.nodes[share > 0.0 ? 1 : 0]];
  for (const EdgeIndex other : edges_of_node_.of(node)) {
    const ContactEdge& next = contact_mesh_.edges[other];
    if (other == index || next.surface != edge.surface || next.is_sharp() != edge.is_sharp()) continue;
    const bool is_first = contact_mesh_.first_alike[next.nodes[0]] == node;
    const Eigen::Vector3d along =
        context.kinematics.x(next.nodes[is_first ? 1 : 0]) - context.kinematics.x(node);
    const double cosine = along.dot(way) / (along.norm() * way.norm());
    if (cosine > alike || (cosine > -alike && (pair_point.is_parallel || other < index))) return false;
  }
  return true;
}

void EdgeEdgeContacts::update(const ContactStepContext& /*context*/, CandidateRows /*rows*/,
                              std::span<const ContactPoint> points) {
  for (const ContactPoint& point : points) {
    slips_now_.add({point.first_edge(), point.second_edge(), point.part}, point.elastic_slip);
    if (!point.is_met()) continue;
    const float depth = std::max(static_cast<float>(-point.gap), std::numeric_limits<float>::min());
    for (const EdgeIndex edge : {point.first_edge(), point.second_edge()})
      depth_now_[edge] = std::max(depth_now_[edge], depth);
  }
}

void EdgeEdgeContacts::mark_close(const ContactStepContext& context, double size_share,
                                  PairRules& rules) const {
  const auto size_of = [&](const ContactEdge& edge) {
    return edge.is_particle()
               ? 2.0 * edge.radius
               : (context.kinematics.x(edge.nodes[1]) - context.kinematics.x(edge.nodes[0])).norm();
  };
  for (const EdgeIndex row : candidates_.rows()) {
    const ContactEdge& first = contact_mesh_.edges[row];
    for (const EdgeIndex partner : candidates_.of(row)) {
      const ContactEdge& second = contact_mesh_.edges[partner];
      const PairIndex pair = *context.rules.find(first.surface, second.surface);
      if (!context.rules[pair].far) continue;
      const SurfacePair& of = *context.rules[pair].pair;
      const double automatic = size_share * std::min(size_of(first), size_of(second));
      const double tolerance = of.capture_tolerance.value_or(of.normal_tolerance.value_or(automatic));
      const EdgePairPoint nearest =
          nearest_points(segment_of(context.kinematics, first), segment_of(context.kinematics, second));
      const double distance =
          (point_at(context.kinematics, first, nearest.s) - point_at(context.kinematics, second, nearest.t))
              .norm();
      if (distance - first.radius_at(nearest.s) - second.radius_at(nearest.t) > tolerance) continue;
      rules.mark_close_edge(pair, row);
      rules.mark_close_edge(pair, partner);
    }
  }
}

void EdgeEdgeContacts::add_start_gaps(const ContactStepContext& context, FoundStartGaps& gaps) const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const EdgeIndex row : candidates_.rows()) {
    const ContactEdge& first = contact_mesh_.edges[row];
    for (const EdgeIndex partner : candidates_.of(row)) {
      const ContactEdge& second = contact_mesh_.edges[partner];
      const PairIndex pair = *context.rules.find(first.surface, second.surface);
      if (!context.rules.gap_offsets().needs_start(pair)) continue;
      const EdgePairPoint nearest =
          nearest_points(segment_of(context.kinematics, first), segment_of(context.kinematics, second));
      const auto found = find_edge_gap(context.kinematics, first, second, nearest, infinite);
      if (!found) continue;
      for (const EdgeIndex edge : {row, partner})
        gaps.edges.push_back({edge.value, pair, found->gap, found->gap, 1.0});
    }
  }
}

bool EdgeEdgeContacts::are_held(const ContactStepContext& context, PairIndex pair, EdgeIndex first,
                                EdgeIndex second) const {
  const ContactEdge &a = contact_mesh_.edges[first], &b = contact_mesh_.edges[second];
  for (const FaceIndex of_a : *a.faces) {
    for (const FaceIndex of_b : *b.faces) {
      if (context.constrained.holds_faces(of_a, of_b) || context.constrained.holds_faces(of_b, of_a))
        return true;
    }
  }
  const auto is_held = [&](const ContactEdge& edge) {
    return std::ranges::any_of(edge.nodes, [&](ContactNodeIndex node) {
      const auto row = contact_mesh_.find_row(node, edge.surface);
      return row && context.constrained.holds_node(*row, pair);
    });
  };
  return is_held(a) || is_held(b);
}

/// As FaceFaceContacts::detect().
void EdgeEdgeContacts::detect(const ContactStepContext& context, CandidateRows rows,
                              std::vector<ContactPoint>& points) const {
  EdgeBounds::Pairs pairs{}, before{};
  std::uint32_t near_before = 0;
  const auto detect_before = [&] {
    for (std::uint32_t left = near_before; left != 0; left &= left - 1) {
      const ContactEdge& edge = contact_mesh_.edges[before.second[first_lane(left)]];
      for (const ContactNodeIndex node : edge.nodes) prefetch(context.kinematics, node);
      if (!edge.is_sharp()) continue;
      for (const FaceIndex face : *edge.faces) prefetch(contact_mesh_.faces[face]);
    }
    for (std::uint32_t left = near_before; left != 0; left &= left - 1)
      detect_one(context, before.first[first_lane(left)], before.second[first_lane(left)], points);
  };
  const EdgeBounds::Reach reach = reach_of_untouched(context);
  const auto cull_pairs = [&] {
    const std::uint32_t near = bounds_.may_touch(pairs, reach);
    for (std::uint32_t left = near; left != 0; left &= left - 1) {
      const EdgeIndex second = pairs.second[first_lane(left)];
      prefetch(contact_mesh_.edges[second]);
      prefetch(depth_before_[second]);
    }
    detect_before();
    before = pairs;
    near_before = near;
    pairs.n = 0;
  };
  close_.visit(
      candidates_, rows, context.candidates, [&](EdgeIndex second) { bounds_.prefetch(second); },
      [&](EdgeIndex first, std::size_t k) {
        pairs.add(first, candidates_.partner(k), k);
        if (pairs.are_full()) cull_pairs();
      });
  cull_pairs();
  detect_before();
}

void EdgeEdgeContacts::detect_one(const ContactStepContext& context, EdgeIndex first_edge,
                                  EdgeIndex second_edge, std::vector<ContactPoint>& points) const {
  const ContactEdge &first = contact_mesh_.edges[first_edge], &second = contact_mesh_.edges[second_edge];
  const double before = std::max(depth_before_[first_edge], depth_before_[second_edge]);
  const bool are_sharp = first.is_sharp() && second.is_sharp();
  const GapOffsets& offsets = context.rules.gap_offsets();
  const PairIndex pair = *context.rules.find(first.surface, second.surface);
  const PairRule& rule = context.rules.of_edges(pair, first_edge, second_edge);
  if (rule.is_balanced != context.balances) return;
  const EdgePairPoints pair_points(segment_of(context.kinematics, first),
                                   segment_of(context.kinematics, second));
  const bool may_be_held = are_sharp && (rule.law == ContactLaw::glued || rule.law == ContactLaw::welded);
  const bool is_on = rule.is_active && rule.law != ContactLaw::tied &&
                     !(may_be_held && are_held(context, pair, first_edge, second_edge));
  for (std::size_t i = 0; is_on && i < pair_points.get().size(); ++i) {
    const EdgePairPoint& pair_point = pair_points.get()[i];
    const Eigen::Vector3d way = point_at(context.kinematics, second, pair_point.t) -
                                point_at(context.kinematics, first, pair_point.s);
    if (!owns(context, first_edge, pair_point.s, pair_point, way) ||
        !owns(context, second_edge, pair_point.t, pair_point, -way))
      continue;
    const Pair edges{first,        second, rule,
                     before > 0.0, before, offsets.of_edges(pair, first_edge, second_edge) + rule.begin_gap};
    ContactPoint point = make_contact_point(context, edges, pair_point);
    if (point.stiffness == 0.0 && !point.is_balanced) continue;
    point.part = static_cast<std::uint8_t>(i);
    point.pair = pair;
    point.first_entity = first_edge.value;
    point.second_entity = second_edge.value;
    if (point.touches() && rule.friction > 0.0) {
      point.elastic_slip = slips_before_.find({first_edge, second_edge, point.part});
      const double stiffness =
          make_pair_penalty(first.penalty_properties, &second.penalty_properties, *rule.pair).stiffness;
      add_friction(stiffness * point.area, rule.slip_limit(point, context.dt), point);
    }
    points.push_back(point);
  }
}

ContactPoint EdgeEdgeContacts::make_contact_point(const ContactStepContext& context, const Pair& pair,
                                                  const EdgePairPoint& pair_point) {
  const auto& [first, second, rule, touched, before, offset] = pair;
  ContactPoint point;
  point.is_of_edges = true;
  point.is_swapped = first.surface != rule.pair->first;
  point.first = side_of(first, pair_point.s);
  point.second = side_of(second, pair_point.t);
  // The sphere around a line's node meets the edges of faces together with the faces.
  if (first.is_sharp() != second.is_sharp() && !is_inside(first.is_sharp() ? pair_point.t : pair_point.s))
    return point;
  const PairPenalty penalty = make_pair_penalty(first.penalty_properties, &second.penalty_properties, rule);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const bool backs_up = context.balances && backs_up_nodes(rule);
  const auto found = find_edge_gap(context.kinematics, first, second, pair_point, infinite, backs_up);
  if (!found) return point;
  const double thinner = std::min(first.penalty_properties.thickness, second.penalty_properties.thickness);
  point.normal = found->normal;
  point.gap = found->gap - offset;
  if (found->is_of_faces) {
    const double left = left_to_nodes * thinner;
    if (!is_off_ends(context.kinematics, first, pair_point.s, left) ||
        !is_off_ends(context.kinematics, second, pair_point.t, left))
      return point;
    point.gap += left;
  }
  point.begin_gap = rule.begin_gap;
  const Eigen::Vector3d relative =
      velocity_at(context.kinematics, point.first, -point.first.radius * point.normal) -
      velocity_at(context.kinematics, point.second, point.second.radius * point.normal);
  const double closing = std::max(0.0, -relative.dot(point.normal)), closed = closing * context.dt;
  const double margin = context.balances ? closed_share * thinner : 0.0;
  if (point.gap > std::max(margin, closing * context.ahead())) return point;
  const double deepest =
      touched ? depth_of_known(penalty.depth, before, closed) : std::max(penalty.depth, 1.5 * closed);
  if ((first.is_sharp() && second.is_sharp()) && point.gap < -deepest - std::max(offset, 0.0)) return point;
  // What turns up deep in each other went in elsewhere: pushing it out here would make energy from nothing.
  const bool is_sharp = first.is_sharp() || second.is_sharp();
  const double shallow = shallow_depth * thinner;
  if (is_sharp && !touched && context.dt > 0.0 && point.gap + closed < -shallow) return point;
  const double width = std::min(first.width, second.width);
  const double area = width * (pair_point.length > 0.0 ? pair_point.length : width);
  push_node({penalty, rule.pair->damping_fraction, area, relative, context.dt, context.coming_dt, relative,
             context.is_static},
            point);
  return point;
}

}  // namespace contactsim

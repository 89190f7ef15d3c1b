// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/node_plane/node_plane_contacts.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "contact/formulations/cohesive_traction.hpp"
#include "contact/formulations/contact_multipliers.hpp"
#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/penalty.hpp"
#include "contact/interface_laws/friction.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

bool has_friction(const PairRule& rule, const ContactPoint& point) {
  return point.touches() && rule.friction != 0.0 && !point.is_balanced;
}

}  // namespace

void NodePlaneContacts::add_pairs() {
  for (const PairIndex i : indices(setup_.rules.rules())) {
    const SurfacePair& pair = *setup_.rules[i].pair;
    for (const auto& [with_plane, other] :
         {std::pair(pair.first, pair.second), std::pair(pair.second, pair.first)}) {
      for (const std::uint32_t plane : setup_.contact.surfaces.surfaces[with_plane].analytic_planes)
        add_pairs(other, i, plane);
      if (pair.first == pair.second) break;
    }
  }
}

void NodePlaneContacts::add_pairs(SurfaceIndex surface, PairIndex pair, std::uint32_t index) {
  const ContactMesh& contact_mesh = setup_.contact_mesh;
  const AnalyticPlane& plane = setup_.contact.planes[index];
  for (const SurfaceNodeIndex row : contact_mesh.rows_of(surface))
    node_plane_pairs_.push_back(
        {row, pair, index, plane.normal.normalized(), plane.origin, Eigen::Vector3d::Zero(), false});
}

void NodePlaneContacts::remap(const ContactRemap& remap) {
  const std::vector<NodePlanePair> before = std::exchange(node_plane_pairs_, {});
  add_pairs();
  using Key = std::tuple<PairIndex, std::uint32_t, SurfaceNodeIndex>;  // with the plane
  std::map<Key, NodePlanePair*> known;
  for (NodePlanePair& pair_of_node : node_plane_pairs_)
    known[{pair_of_node.pair, pair_of_node.plane, pair_of_node.row}] = &pair_of_node;
  for (const NodePlanePair& old : before) {
    const OptionalIndex<SurfaceNodeIndex> row = remap.rows[old.row];
    if (!row) continue;
    const auto found = known.find({old.pair, old.plane, *row});
    if (found == known.end()) continue;
    found->second->elastic_slip = old.elastic_slip;
    found->second->touched = old.touched;
  }
}

void NodePlaneContacts::archive(StateArchive& saved) {
  saved.fixed_rows("contact/planes/elastic_slip", node_plane_pairs_,
                   [](NodePlanePair& pair_of_node, RowNumbers& row) { row(pair_of_node.elastic_slip); });
  if (!setup_.rules.may_hold()) return;
  saved.fixed_rows("contact/planes/touched", node_plane_pairs_,
                   [](NodePlanePair& pair_of_node, RowNumbers& row) { row(pair_of_node.touched); });
}

double NodePlaneContacts::gap_of(const ContactKinematics& kinematics, const NodePlanePair& candidate) const {
  const SurfaceNode& node = setup_.contact_mesh.surface_nodes[candidate.row];
  return (kinematics.x(node.node) - candidate.origin).dot(candidate.normal) - node.radius;
}

/// A plane has no end: nodes are near it that are no farther than half an element.
void NodePlaneContacts::add_start_gaps(const ContactStepContext& context, FoundStartGaps& gaps) const {
  constexpr double near_share = 0.5;
  for (const NodePlanePair& candidate : node_plane_pairs_) {
    if (!context.rules.gap_offsets().needs_start(candidate.pair)) continue;
    const SurfacePair& pair = *context.rules[candidate.pair].pair;
    const SurfaceNode& node = setup_.contact_mesh.surface_nodes[candidate.row];
    const double reach = pair.normal_tolerance.value_or(near_share * node.penalty_properties.thickness);
    const double gap = gap_of(context.kinematics, candidate);
    if (gap <= reach) gaps.nodes.push_back({candidate.row.value, candidate.pair, gap, gap, node.area});
  }
}

void NodePlaneContacts::detect(const ContactStepContext& context, CandidateRows rows,
                               std::vector<ContactPoint>& points) const {
  for (std::size_t row = rows.begin; row < rows.end; ++row) {
    const NodePlanePair& candidate = node_plane_pairs_[row];
    const PairRule& rule = context.rules.of_node(candidate.pair, candidate.row);
    if (!context.rules.start_reach().may_meet_plane(candidate.pair, candidate.row)) continue;
    if (context.enforces(rule)) detect_one(context, candidate, rule, points);
  }
}

void NodePlaneContacts::detect_one(const ContactStepContext& context, const NodePlanePair& candidate,
                                   const PairRule& rule, std::vector<ContactPoint>& points) const {
  const SurfaceNode& node = setup_.contact_mesh.surface_nodes[candidate.row];
  const Eigen::Vector3d arm = -static_cast<double>(node.radius) * candidate.normal;
  const double deeper =
      context.multipliers ? context.multipliers->value_or(candidate.pair, candidate.row, 0.0) : 0.0;
  const double gap = gap_of(context.kinematics, candidate) -
                     context.rules.gap_offsets().of_node(candidate.pair, candidate.row) - rule.begin_gap -
                     deeper;
  const Eigen::Vector3d velocity = context.kinematics.velocity_beside(node.node, arm);
  const double margin = context.balances ? closed_share * node.penalty_properties.thickness : 0.0;
  const double near = -context.ahead() * velocity.dot(candidate.normal);
  const bool pulls = candidate.touched && gap <= rule.pair->held_gap(node.penalty_properties.thickness) &&
                     !rule.pair->separates;
  if (gap > std::max({rule.activation_distance, margin, near}) && !pulls) return;
  ContactPoint& point = points.emplace_back();
  point.pair = candidate.pair;
  point.is_swapped = node.surface != rule.pair->first;
  point.first_entity = candidate.row.value;
  point.part = static_cast<std::uint8_t>(candidate.plane);
  point.first.nodes.fill(node.node);
  point.first.weights = Eigen::Vector4d::UnitX();
  point.first.radius = node.radius;
  point.normal = candidate.normal;
  point.gap = gap;
  point.begin_gap = rule.begin_gap + deeper;
  point.pulls = pulls;
  const PairPenalty penalty = make_pair_penalty(node.penalty_properties, nullptr, rule);
  const double area = context.kinematics.area_against(node, candidate.normal);
  const NodePenaltyInput push{penalty,
                              rule.pair->damping_fraction,
                              area,
                              velocity,
                              context.dt,
                              context.coming_dt,
                              context.kinematics.last_velocity_beside(node.node, arm),
                              context.is_static};
  push_node(push, point);
  if (rule.acts_apart()) {
    point.elastic_slip = candidate.elastic_slip;
    add_node_traction(*rule.interface_law, push, point);
  }
  if (!has_friction(rule, point)) return;
  if (!rule.acts_apart()) point.elastic_slip = candidate.elastic_slip;
  add_friction(penalty.stiffness * area, rule.slip_limit(point, context.dt), point);
}

/// The slip of a node that is near and does not touch stays.
void NodePlaneContacts::update(const ContactStepContext& context, CandidateRows rows,
                               std::span<const ContactPoint> points) {
  auto point = points.begin();
  for (std::size_t row = rows.begin; row < rows.end; ++row) {
    NodePlanePair& candidate = node_plane_pairs_[row];
    const PairRule& rule = context.rules.of_node(candidate.pair, candidate.row);
    if (rule.is_balanced != context.balances) continue;
    const bool is_near = point != points.end() && point->row() == candidate.row &&
                         point->pair == candidate.pair &&
                         point->part == static_cast<std::uint8_t>(candidate.plane);
    if (!is_near) {
      candidate.elastic_slip.setZero();
      candidate.touched = false;
      continue;
    }
    candidate.touched = point->is_met();
    if (rule.acts_apart() || has_friction(rule, *point)) candidate.elastic_slip = point->elastic_slip;
    ++point;
  }
}

}  // namespace contactsim

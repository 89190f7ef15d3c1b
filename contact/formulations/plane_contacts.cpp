// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/plane_contacts.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "contact/formulations/cohesive_traction.hpp"
#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/penalty.hpp"
#include "contact/interface_laws/friction.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

void PlaneContacts::add_pairs(const ContactSurfaces& surfaces, std::span<const AnalyticPlane> planes,
                              const PairRules& rules) {
  for (std::uint32_t i = 0; i < rules.rules().size(); ++i) {
    const SurfacePair& pair = *rules[i].pair;
    for (const auto& [with_plane, other] :
         {std::pair(pair.first, pair.second), std::pair(pair.second, pair.first)}) {
      for (const std::uint32_t plane : surfaces.surfaces[with_plane].analytic_planes)
        add_pairs(other, i, plane, planes[plane]);
      if (pair.first == pair.second) break;
    }
  }
}

void PlaneContacts::add_pairs(std::uint32_t surface, std::uint32_t pair, std::uint32_t index,
                              const AnalyticPlane& plane) {
  for (std::uint32_t node = contact_mesh_.first_node[surface]; node < contact_mesh_.first_node[surface + 1];
       ++node)
    node_plane_pairs_.push_back(
        {node, pair, index, plane.normal.normalized(), plane.origin, Eigen::Vector3d::Zero()});
}

void PlaneContacts::remap(const ContactSurfaces& surfaces, std::span<const AnalyticPlane> planes,
                          const PairRules& rules, const ContactRemap& remap) {
  const std::vector<NodePlanePair> before = std::exchange(node_plane_pairs_, {});
  add_pairs(surfaces, planes, rules);
  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;  // pair, plane, node
  std::map<Key, NodePlanePair*> known;
  for (NodePlanePair& pair_of_node : node_plane_pairs_)
    known[{pair_of_node.pair, pair_of_node.plane, pair_of_node.node}] = &pair_of_node;
  for (const NodePlanePair& old : before) {
    const auto found = known.find({old.pair, old.plane, remap.rows[old.node]});
    if (found != known.end()) found->second->elastic_slip = old.elastic_slip;
  }
}

void PlaneContacts::archive(StateArchive& saved) {
  saved.fixed_rows("contact/planes/elastic_slip", node_plane_pairs_,
                   [](NodePlanePair& pair_of_node, RowNumbers& row) { row(pair_of_node.elastic_slip); });
}

void PlaneContacts::find(const ContactStepContext& context, std::size_t begin, std::size_t end,
                         std::vector<ContactPoint>& points) {
  for (std::size_t row = begin; row < end; ++row) {
    NodePlanePair& pair_of_node = node_plane_pairs_[row];
    const PairRule& rule = context.rules.of_node(pair_of_node.pair, pair_of_node.node);
    if (rule.is_balanced != context.balances) continue;
    const SurfaceNode& node = contact_mesh_.surface_nodes[pair_of_node.node];
    const double gap =
        (context.kinematics.x(node.node) - pair_of_node.origin).dot(pair_of_node.normal) - node.radius;
    const Eigen::Vector3d velocity = context.kinematics.velocity_beside(
        node.node, -static_cast<double>(node.radius) * pair_of_node.normal);
    const double speed = velocity.dot(pair_of_node.normal);
    const double margin = context.balances ? closed_share * node.penalty_properties.thickness : 0.0;
    if (!rule.is_active || gap > std::max({rule.activation_distance, margin, -context.ahead() * speed})) {
      pair_of_node.elastic_slip.setZero();
      continue;
    }
    const PairPenalty penalty = make_pair_penalty(node.penalty_properties, nullptr, *rule.pair);
    ContactPoint& point = points.emplace_back();
    point.pair = pair_of_node.pair;
    point.is_swapped = node.surface != rule.pair->first;
    point.first_entity = pair_of_node.node;
    point.part = static_cast<std::uint8_t>(pair_of_node.plane);
    point.first.nodes.fill(node.node);
    point.first.weights = Eigen::Vector4d::UnitX();
    point.first.radius = node.radius;
    point.normal = pair_of_node.normal;
    point.gap = gap;
    const double area = context.kinematics.area_against(node, pair_of_node.normal);
    const NodePenaltyInput push{penalty,
                                rule.pair->damping_fraction,
                                area,
                                velocity,
                                context.dt,
                                context.coming_dt,
                                context.kinematics.last_velocity_beside(
                                    node.node, -static_cast<double>(node.radius) * pair_of_node.normal)};
    push_node(push, point);
    if (rule.acts_apart()) {
      point.elastic_slip = pair_of_node.elastic_slip;
      add_node_traction(*rule.interface_law, push, point);
      pair_of_node.elastic_slip = point.elastic_slip;
    }
    if (!point.touches() || rule.friction == 0.0 || point.is_balanced) continue;
    point.elastic_slip = pair_of_node.elastic_slip;
    add_friction(penalty.stiffness * area, rule.slip_limit(point, context.dt), point);
    pair_of_node.elastic_slip = point.elastic_slip;
  }
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/plane_contacts.hpp"

#include <algorithm>

#include "contact/contact_place.hpp"
#include "contact/friction.hpp"
#include "contact/gap_pull.hpp"
#include "contact/penalty.hpp"

namespace contactsim {

PlaneContacts::PlaneContacts(const ContactFaces& faces, const ContactSurfaces& surfaces,
                             std::span<const AnalyticPlane> planes, const PairRules& rules)
    : faces_(faces) {
  for (std::uint32_t i = 0; i < rules.rules().size(); ++i) {
    const SurfacePair& pair = *rules[i].pair;
    for (const auto& [with_plane, other] :
         {std::pair(pair.first, pair.second), std::pair(pair.second, pair.first)}) {
      for (const std::uint32_t plane : surfaces.surfaces[with_plane].analytic_planes)
        add_places(other, i, planes[plane]);
      if (pair.first == pair.second) break;
    }
  }
}

void PlaneContacts::add_places(std::uint32_t surface, std::uint32_t pair, const AnalyticPlane& plane) {
  for (std::uint32_t node = faces_.first_node[surface]; node < faces_.first_node[surface + 1]; ++node)
    places_.push_back({node, pair, plane.normal.normalized(), plane.origin, Eigen::Vector3d::Zero()});
}

void PlaneContacts::take_over(const PlaneContacts& before, const ContactRenumbering& places) {
  // Both stand in the order of pairs, planes and nodes.
  auto now = places_.begin();
  for (const Place& old : before.places_) {
    const std::uint32_t node = places.rows[old.node];
    if (node == ContactRenumbering::gone) continue;
    const auto is_same = [&](const Place& place) {
      return place.node == node && place.pair == old.pair && place.normal == old.normal &&
             place.origin == old.origin;
    };
    const auto found = std::find_if(now, places_.end(), is_same);
    if (found == places_.end()) continue;
    found->elastic = old.elastic;
    now = found + 1;
  }
}

void PlaneContacts::find(const ContactScene& scene, std::size_t begin, std::size_t end,
                         std::vector<ContactRecord>& records) {
  for (std::size_t row = begin; row < end; ++row) {
    Place& place = places_[row];
    const PairRule& rule = scene.rules.of_node(place.pair, place.node);
    const SurfaceNode& node = faces_.surface_nodes[place.node];
    const double gap = (scene.surface.x(node.node) - place.origin).dot(place.normal);
    const Eigen::Vector3d velocity = scene.surface.v(node.node);
    const double speed = velocity.dot(place.normal);
    if (!rule.is_active || gap > std::max(rule.reach, -steps_ahead * scene.dt * speed)) {
      if (!scene.is_frozen) place.elastic.setZero();
      continue;
    }
    const PairPenalty penalty = make_pair_penalty(node.backing, nullptr, *rule.pair);
    ContactRecord& record = records.emplace_back();
    record.pair = place.pair;
    record.is_swapped = node.surface != rule.pair->first;
    record.first_place = place.node;
    record.first.nodes.fill(node.node);
    record.first.weights = Eigen::Vector4d::UnitX();
    record.normal = place.normal;
    record.gap = gap;
    const double area = scene.surface.area_against(node, place.normal);
    const NodePush push{penalty, rule.pair->damping_fraction, area, velocity, scene.dt};
    push_node(push, record);
    if (rule.acts_apart()) {
      record.elastic = place.elastic;
      pull_node(*rule.place, push, scene.is_frozen, record);
      if (!scene.is_frozen) place.elastic = record.elastic;
    }
    if (!record.touches() || rule.friction == 0.0) continue;
    record.elastic = place.elastic;
    add_friction(penalty.stiffness * area, rule.slip_limit(record, scene.dt), scene.is_frozen, record);
    if (!scene.is_frozen) place.elastic = record.elastic;
  }
}

}  // namespace contactsim

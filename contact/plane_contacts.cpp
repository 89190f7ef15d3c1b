// SPDX-License-Identifier: BSD-3-Clause
#include "contact/plane_contacts.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "contact/contact_place.hpp"
#include "contact/friction.hpp"
#include "contact/gap_pull.hpp"
#include "contact/penalty.hpp"
#include "core/state_archive.hpp"

namespace contactsim {

void PlaneContacts::add_places(const ContactSurfaces& surfaces, std::span<const AnalyticPlane> planes,
                               const PairRules& rules) {
  for (std::uint32_t i = 0; i < rules.rules().size(); ++i) {
    const SurfacePair& pair = *rules[i].pair;
    for (const auto& [with_plane, other] :
         {std::pair(pair.first, pair.second), std::pair(pair.second, pair.first)}) {
      for (const std::uint32_t plane : surfaces.surfaces[with_plane].analytic_planes)
        add_places(other, i, plane, planes[plane]);
      if (pair.first == pair.second) break;
    }
  }
}

void PlaneContacts::add_places(std::uint32_t surface, std::uint32_t pair, std::uint32_t index,
                               const AnalyticPlane& plane) {
  for (std::uint32_t node = faces_.first_node[surface]; node < faces_.first_node[surface + 1]; ++node)
    places_.push_back({node, pair, index, plane.normal.normalized(), plane.origin, Eigen::Vector3d::Zero()});
}

void PlaneContacts::renumber(const ContactSurfaces& surfaces, std::span<const AnalyticPlane> planes,
                             const PairRules& rules, const ContactRenumbering& places) {
  const std::vector<Place> before = std::exchange(places_, {});
  add_places(surfaces, planes, rules);
  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;  // pair, plane, node
  std::map<Key, Place*> known;
  for (Place& place : places_) known[{place.pair, place.plane, place.node}] = &place;
  for (const Place& old : before) {
    const auto found = known.find({old.pair, old.plane, places.rows[old.node]});
    if (found != known.end()) found->second->elastic = old.elastic;
  }
}

void PlaneContacts::archive(StateArchive& saved) {
  saved.fixed_rows("contact/planes/elastic_slip", places_,
                   [](Place& place, RowNumbers& row) { row(place.elastic); });
}

void PlaneContacts::find(const ContactScene& scene, std::size_t begin, std::size_t end,
                         std::vector<ContactRecord>& records) {
  for (std::size_t row = begin; row < end; ++row) {
    Place& place = places_[row];
    const PairRule& rule = scene.rules.of_node(place.pair, place.node);
    if (rule.is_balanced != scene.balances) continue;
    const SurfaceNode& node = faces_.surface_nodes[place.node];
    const double gap = (scene.surface.x(node.node) - place.origin).dot(place.normal) - node.radius;
    const Eigen::Vector3d velocity =
        scene.surface.velocity_beside(node.node, -static_cast<double>(node.radius) * place.normal);
    const double speed = velocity.dot(place.normal);
    const double margin = scene.balances ? closed_share * node.backing.thickness : 0.0;
    if (!rule.is_active || gap > std::max({rule.reach, margin, -scene.ahead() * speed})) {
      place.elastic.setZero();
      continue;
    }
    const PairPenalty penalty = make_pair_penalty(node.backing, nullptr, *rule.pair);
    ContactRecord& record = records.emplace_back();
    record.pair = place.pair;
    record.is_swapped = node.surface != rule.pair->first;
    record.first_place = place.node;
    record.part = static_cast<std::uint8_t>(place.plane);
    record.first.nodes.fill(node.node);
    record.first.weights = Eigen::Vector4d::UnitX();
    record.first.radius = node.radius;
    record.normal = place.normal;
    record.gap = gap;
    const double area = scene.surface.area_against(node, place.normal);
    const NodePush push{
        penalty,
        rule.pair->damping_fraction,
        area,
        velocity,
        scene.dt,
        scene.coming_dt,
        scene.surface.last_velocity_beside(node.node, -static_cast<double>(node.radius) * place.normal)};
    push_node(push, record);
    if (rule.acts_apart()) {
      record.elastic = place.elastic;
      pull_node(*rule.place, push, record);
      place.elastic = record.elastic;
    }
    if (!record.touches() || rule.friction == 0.0 || record.is_balanced) continue;
    record.elastic = place.elastic;
    add_friction(penalty.stiffness * area, rule.slip_limit(record, scene.dt), record);
    place.elastic = record.elastic;
  }
}

}  // namespace contactsim

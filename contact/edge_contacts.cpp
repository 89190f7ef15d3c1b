// SPDX-License-Identifier: BSD-3-Clause
#include "contact/edge_contacts.hpp"

#include <algorithm>
#include <utility>

#include "contact/contact_place.hpp"
#include "contact/friction.hpp"
#include "contact/penalty.hpp"

namespace contactsim {

namespace {

const std::array<Eigen::Vector3d, 2> no_slip{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};

Segment segment_of(const MovingSurface& surface, const ContactEdge& edge) {
  Segment segment;
  segment << surface.x(edge.nodes[0]), surface.x(edge.nodes[1]);
  return segment;
}

RecordSide side_of(const ContactEdge& edge, double share) {
  return {{edge.nodes[0], edge.nodes[1], edge.nodes[1], edge.nodes[1]}, {1.0 - share, share, 0.0, 0.0},
          edge.radius};
}

/// The velocity of the surface of an edge at a place.
///   arm  from the axis to the surface [length]
Eigen::Vector3d velocity_at(const MovingSurface& surface, const RecordSide& side, const Eigen::Vector3d& arm) {
  return side.weights[0] * surface.velocity_beside(side.nodes[0], arm) +
         side.weights[1] * surface.velocity_beside(side.nodes[1], arm);
}

}  // namespace

void EdgeContacts::take_candidates() {
  elastic_ = carry_over<Elastic>(candidates_, elastic_, next_, no_slip);
  candidates_ = std::exchange(next_, {});
}

void EdgeContacts::find(const ContactScene& scene, std::size_t begin, std::size_t end,
                        std::vector<ContactRecord>& records) {
  for (std::size_t row = begin; row < end; ++row) {
    for (std::size_t k = candidates_.begin[row]; k < candidates_.begin[row + 1]; ++k)
      find_one(scene, static_cast<std::uint32_t>(row), k, records);
  }
}

void EdgeContacts::find_one(const ContactScene& scene, std::uint32_t first_edge, std::size_t candidate,
                            std::vector<ContactRecord>& records) {
  const ContactEdge &first = faces_.edges[first_edge], &second = faces_.edges[candidates_.partners[candidate]];
  const std::uint32_t pair = scene.rules.find(first.surface, second.surface);
  const PairRule& rule = scene.rules[pair];
  Elastic held = std::exchange(elastic_[candidate], no_slip);
  if (scene.is_frozen) elastic_[candidate] = held;
  if (!rule.is_active || rule.law == ContactLaw::tied) return;
  const EdgePlaces places(segment_of(scene.surface, first), segment_of(scene.surface, second));
  for (std::size_t i = 0; i < places.get().size(); ++i) {
    ContactRecord record = make_record(scene, first, second, places.get()[i]);
    if (record.stiffness == 0.0) continue;
    record.pair = pair;
    record.is_swapped = first.surface != rule.pair->first;
    record.first_place = first_edge;
    record.second_place = candidates_.partners[candidate];
    if (record.touches() && rule.friction > 0.0) {
      record.elastic = held[i];
      const double stiffness = make_pair_penalty(first.backing, &second.backing, *rule.pair).stiffness;
      add_friction(stiffness * record.area, rule.slip_limit(record, scene.dt), scene.is_frozen, record);
      if (!scene.is_frozen) elastic_[candidate][i] = record.elastic;
    }
    records.push_back(record);
  }
}

ContactRecord EdgeContacts::make_record(const ContactScene& scene, const ContactEdge& first,
                                        const ContactEdge& second, const EdgePlace& place) const {
  ContactRecord record;
  record.is_of_edges = true;
  record.first = side_of(first, place.s);
  record.second = side_of(second, place.t);
  const auto at = [&](const RecordSide& side) -> Eigen::Vector3d {
    return side.weights[0] * scene.surface.x(side.nodes[0]) + side.weights[1] * scene.surface.x(side.nodes[1]);
  };
  const Eigen::Vector3d apart = at(record.first) - at(record.second);
  const double distance = apart.norm();
  if (distance == 0.0) return record;
  record.normal = apart / distance;
  record.gap = distance - first.radius - second.radius;
  const SurfacePair& pair = *scene.rules.rules()[scene.rules.find(first.surface, second.surface)].pair;
  const PairPenalty penalty = make_pair_penalty(first.backing, &second.backing, pair);
  const Eigen::Vector3d relative =
      velocity_at(scene.surface, record.first, -first.radius * record.normal) -
      velocity_at(scene.surface, record.second, second.radius * record.normal);
  if (record.gap > steps_ahead * std::max(0.0, -relative.dot(record.normal)) * scene.dt) return record;
  const double width = 2.0 * std::min(first.radius, second.radius);
  const double area = width * (place.length > 0.0 ? place.length : width);
  push_node({penalty, pair.damping_fraction, area, relative, scene.dt}, record);
  return record;
}

}  // namespace contactsim

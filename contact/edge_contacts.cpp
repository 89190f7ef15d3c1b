// SPDX-License-Identifier: BSD-3-Clause
#include "contact/edge_contacts.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "contact/contact_place.hpp"
#include "contact/friction.hpp"
#include "contact/penalty.hpp"
#include "contact/sharp_edges.hpp"
#include "core/state_archive.hpp"

namespace contactsim {

namespace {

const std::array<Eigen::Vector3d, 2> no_slip{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};

/// Nearer than this share to an end of an edge a place is at the end.
constexpr double at_end = 1e-9;

bool is_inside(double share) { return share > at_end && share < 1.0 - at_end; }

Segment segment_of(const MovingSurface& surface, const ContactEdge& edge) {
  Segment segment;
  segment << surface.x(edge.nodes[0]), surface.x(edge.nodes[1]);
  return segment;
}

RecordSide side_of(const ContactEdge& edge, double share) {
  return {{edge.nodes[0], edge.nodes[1], edge.nodes[1], edge.nodes[1]},
          {1.0 - share, share, 0.0, 0.0},
          edge.radius};
}

/// The velocity of the surface of an edge at a place.
///   arm  from the axis to the surface [length]
Eigen::Vector3d velocity_at(const MovingSurface& surface, const RecordSide& side,
                            const Eigen::Vector3d& arm) {
  return side.weights[0] * surface.velocity_beside(side.nodes[0], arm) +
         side.weights[1] * surface.velocity_beside(side.nodes[1], arm);
}

/// Whether two sharp edges may cross, seen along the normal of both, near enough to touch soon. Says yes
/// rather too often.
///   dt_ahead  within which they may close [time]
bool may_cross(const MovingSurface& surface, const ContactEdge& first, const ContactEdge& second,
               double dt_ahead) {
  constexpr double parallel = 0.02, beside = 1e-4;  // less strict than find_edge_gap()
  const Eigen::Vector3d a = surface.x(first.nodes[0]), b = surface.x(second.nodes[0]);
  const Eigen::Vector3d p = surface.x(first.nodes[1]) - a, q = surface.x(second.nodes[1]) - b;
  const Eigen::Vector3d normal = p.cross(q), apart = b - a;
  const double square = normal.squaredNorm();
  if (!(square > parallel * p.squaredNorm() * q.squaredNorm())) return false;
  const double s = apart.cross(q).dot(normal), t = apart.cross(p).dot(normal);
  if (s < -beside * square || s > (1.0 + beside) * square) return false;
  if (t < -beside * square || t > (1.0 + beside) * square) return false;
  const auto v = [&](const ContactEdge& edge, std::size_t k) { return surface.v(edge.nodes[k]); };
  double speed = 0.0;
  for (std::size_t k = 0; k < 4; ++k) speed = std::max(speed, (v(first, k / 2) - v(second, k % 2)).norm());
  const double height = apart.dot(normal), reach = first.backing.thickness + speed * dt_ahead;
  return height * height <= reach * reach * square;
}

/// Lines and sharp edges by first_alike of their nodes; nothing without any edges.
PairLists list_edges_of_nodes(const ContactFaces& faces) {
  if (faces.edges.empty()) return {};
  return list_by_row(faces.n_nodes(), [&](const auto& take) {
    for (std::uint32_t i = 0; i < faces.edges.size(); ++i) {
      const ContactEdge& edge = faces.edges[i];
      if (edge.is_particle()) continue;
      for (const std::uint32_t node : edge.nodes) take(faces.first_alike[node], i);
    }
  });
}

}  // namespace

EdgeContacts::EdgeContacts(const ContactFaces& faces)
    : faces_(faces), depth_before_(faces.edges.size(), 0.0f), depth_now_(faces.edges.size(), 0.0f) {
  edges_of_node_ = list_edges_of_nodes(faces);
}

bool EdgeContacts::owns(const ContactScene& scene, std::uint32_t index, double share, const EdgePlace& place,
                        const Eigen::Vector3d& way) const {
  constexpr double alike = 1e-6;  // cosine of directions that count as square to the way
  const ContactEdge& edge = faces_.edges[index];
  if (edge.is_sharp() || edge.is_particle() || (share > 0.0 && share < 1.0) || place.length > 0.0)
    return true;
  const std::uint32_t node = faces_.first_alike[edge.nodes[share > 0.0 ? 1 : 0]];
  for (const std::uint32_t other : edges_of_node_.of(node)) {
    const ContactEdge& next = faces_.edges[other];
    if (other == index || next.surface != edge.surface || next.is_sharp() != edge.is_sharp()) continue;
    const bool is_first = faces_.first_alike[next.nodes[0]] == node;
    const Eigen::Vector3d along = scene.surface.x(next.nodes[is_first ? 1 : 0]) - scene.surface.x(node);
    const double cosine = along.dot(way) / (along.norm() * way.norm());
    if (cosine > alike || (cosine > -alike && (place.is_parallel || other < index))) return false;
  }
  return true;
}

void EdgeContacts::take_candidates() {
  elastic_ = carry_over<Elastic>(candidates_, elastic_, next_, no_slip);
  candidates_ = std::exchange(next_, {});
}

void EdgeContacts::begin_step() {
  std::swap(depth_before_, depth_now_);
  std::fill(depth_now_.begin(), depth_now_.end(), 0.0f);
}

void EdgeContacts::note(const ContactRecord& record) {
  if (!record.is_met()) return;
  const float depth = std::max(static_cast<float>(-record.gap), std::numeric_limits<float>::min());
  for (const std::uint32_t edge : {record.first_place, record.second_place})
    depth_now_[edge] = std::max(depth_now_[edge], depth);
}

void EdgeContacts::archive(StateArchive& saved) {
  contactsim::archive("contact/edge_pairs", candidates_, saved);
  saved.rows("contact/edge_pairs/elastic_slip", elastic_, [](Elastic& slip, RowNumbers& row) { row(slip); });
  saved.list("contact/edges/depth", depth_now_);
}

void EdgeContacts::mark_close(const ContactScene& scene, double size_share, PairRules& rules) const {
  const auto size_of = [&](const ContactEdge& edge) {
    return edge.is_particle() ? 2.0 * edge.radius
                              : (scene.surface.x(edge.nodes[1]) - scene.surface.x(edge.nodes[0])).norm();
  };
  for (std::uint32_t row = 0; row < candidates_.n_rows(); ++row) {
    const ContactEdge& first = faces_.edges[row];
    for (const std::uint32_t partner : candidates_.of(row)) {
      const ContactEdge& second = faces_.edges[partner];
      const std::uint32_t pair = scene.rules.find(first.surface, second.surface);
      if (scene.rules[pair].far == PairRule::not_hybrid) continue;
      const SurfacePair& of = *scene.rules[pair].pair;
      const double automatic = size_share * std::min(size_of(first), size_of(second));
      const double tolerance = of.capture_tolerance.value_or(of.normal_tolerance.value_or(automatic));
      const EdgePlace nearest =
          nearest_points(segment_of(scene.surface, first), segment_of(scene.surface, second));
      const double distance =
          (point_at(scene.surface, first, nearest.s) - point_at(scene.surface, second, nearest.t)).norm();
      if (distance - first.radius - second.radius > tolerance) continue;
      rules.mark_close_edge(pair, row);
      rules.mark_close_edge(pair, partner);
    }
  }
}

bool EdgeContacts::are_held(const ContactScene& scene, std::uint32_t pair, std::uint32_t first,
                            std::uint32_t second) const {
  const ContactEdge &a = faces_.edges[first], &b = faces_.edges[second];
  for (const std::uint32_t of_a : a.faces) {
    for (const std::uint32_t of_b : b.faces) {
      if (scene.glued.holds_faces(of_a, of_b) || scene.glued.holds_faces(of_b, of_a)) return true;
    }
  }
  const auto is_held = [&](const ContactEdge& edge) {
    return std::ranges::any_of(edge.nodes, [&](std::uint32_t node) {
      const auto row = faces_.find_row(node, edge.surface);
      return row && scene.glued.holds_node(*row, pair);
    });
  };
  return is_held(a) || is_held(b);
}

void EdgeContacts::renumber(const ContactRenumbering& places) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Elastic> kept;
  for (std::size_t row = 0; row < candidates_.n_rows(); ++row) {
    for (std::size_t k = candidates_.begin[row]; k < candidates_.begin[row + 1]; ++k) {
      const std::uint32_t first = places.edges[row], second = places.edges[candidates_.partners[k]];
      // Of edges that have changed their order the slip would be seen from the other side.
      if (second != ContactRenumbering::gone && first < second) kept[{first, second}] = elastic_[k];
    }
  }
  candidates_ = {};
  elastic_.clear();
  auto pair = kept.begin();
  for (std::uint32_t row = 0; row < places.n_edges_after; ++row) {
    for (; pair != kept.end() && pair->first.first == row; ++pair) {
      candidates_.partners.push_back(pair->first.second);
      elastic_.push_back(pair->second);
    }
    candidates_.begin.push_back(static_cast<std::uint32_t>(candidates_.partners.size()));
  }
  edges_of_node_ = list_edges_of_nodes(faces_);
  carry(places.edges, places.n_edges_after, 0.0f, depth_before_);
  carry(places.edges, places.n_edges_after, 0.0f, depth_now_);
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
  const std::uint32_t second_edge = candidates_.partners[candidate];
  const ContactEdge &first = faces_.edges[first_edge], &second = faces_.edges[second_edge];
  const double before = std::max(depth_before_[first_edge], depth_before_[second_edge]);
  const bool are_sharp = first.is_sharp() && second.is_sharp();
  // What touched nothing holds no slip.
  if (are_sharp && before == 0.0 && !may_cross(scene.surface, first, second, scene.ahead())) return;
  const std::uint32_t pair = scene.rules.find(first.surface, second.surface);
  const PairRule& rule = scene.rules.of_edges(pair, first_edge, second_edge);
  if (rule.is_balanced != scene.balances) return;
  const Elastic held = elastic_[candidate];
  Elastic now = no_slip;
  const EdgePlaces places(segment_of(scene.surface, first), segment_of(scene.surface, second));
  const bool may_be_held = are_sharp && (rule.law == ContactLaw::glued || rule.law == ContactLaw::welded);
  const bool is_on = rule.is_active && rule.law != ContactLaw::tied &&
                     !(may_be_held && are_held(scene, pair, first_edge, second_edge));
  for (std::size_t i = 0; is_on && i < places.get().size(); ++i) {
    const EdgePlace& place = places.get()[i];
    const Eigen::Vector3d way =
        point_at(scene.surface, second, place.t) - point_at(scene.surface, first, place.s);
    if (!owns(scene, first_edge, place.s, place, way) || !owns(scene, second_edge, place.t, place, -way))
      continue;
    ContactRecord record = make_record(scene, {first, second, rule, before > 0.0, before}, place);
    if (record.stiffness == 0.0 && !record.is_balanced) continue;
    record.part = static_cast<std::uint8_t>(i);
    record.pair = pair;
    record.first_place = first_edge;
    record.second_place = second_edge;
    if (record.touches() && rule.friction > 0.0) {
      record.elastic = held[i];
      const double stiffness = make_pair_penalty(first.backing, &second.backing, *rule.pair).stiffness;
      add_friction(stiffness * record.area, rule.slip_limit(record, scene.dt), record);
      now[i] = record.elastic;
    }
    records.push_back(record);
  }
  elastic_[candidate] = now;
}

ContactRecord EdgeContacts::make_record(const ContactScene& scene, const Pair& pair, const EdgePlace& place) {
  const auto& [first, second, rule, touched, before] = pair;
  ContactRecord record;
  record.is_of_edges = true;
  record.is_swapped = first.surface != rule.pair->first;
  record.first = side_of(first, place.s);
  record.second = side_of(second, place.t);
  // The ball around a line's node meets the edges of faces together with the faces.
  if (first.is_sharp() != second.is_sharp() && !is_inside(first.is_sharp() ? place.t : place.s))
    return record;
  const PairPenalty penalty = make_pair_penalty(first.backing, &second.backing, *rule.pair);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto found = find_edge_gap(scene.surface, first, second, place, infinite);
  if (!found) return record;
  record.normal = found->normal;
  record.gap = found->gap;
  const Eigen::Vector3d relative = velocity_at(scene.surface, record.first, -first.radius * record.normal) -
                                   velocity_at(scene.surface, record.second, second.radius * record.normal);
  const double closing = std::max(0.0, -relative.dot(record.normal)), closed = closing * scene.dt;
  const double thinner = std::min(first.backing.thickness, second.backing.thickness);
  const double margin = scene.balances ? closed_share * thinner : 0.0;
  if (record.gap > std::max(margin, closing * scene.ahead())) return record;
  const double deepest = touched && scene.balances ? infinite
                         : touched                 ? depth_of_known(penalty.depth, before, closed)
                                                   : std::max(penalty.depth, 1.5 * closed);
  if ((first.is_sharp() && second.is_sharp()) && record.gap < -deepest) return record;
  // What turns up deep in each other went in elsewhere: pushing it out here would make energy from nothing.
  const bool is_sharp = first.is_sharp() || second.is_sharp();
  const double shallow = shallow_depth * thinner;
  if (is_sharp && !touched && scene.dt > 0.0 && record.gap + closed < -shallow) return record;
  const double width = std::min(first.width, second.width);
  const double area = width * (place.length > 0.0 ? place.length : width);
  push_node({penalty, rule.pair->damping_fraction, area, relative, scene.dt, scene.coming_dt, relative},
            record);
  return record;
}

}  // namespace contactsim

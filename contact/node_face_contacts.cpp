// SPDX-License-Identifier: BSD-3-Clause
#include "contact/node_face_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "contact/contact_place.hpp"
#include "contact/flush_rims.hpp"
#include "contact/friction.hpp"
#include "contact/gap_pull.hpp"
#include "contact/make_ties.hpp"
#include "contact/node_face.hpp"
#include "contact/penalty.hpp"

namespace contactsim {

namespace {

/// A node that stands this share of a face's size beyond its edge counts as over it: bodies whose edges lie
/// over each other keep touching when they spread by different strains.
constexpr double automatic_beyond = 0.02;

/// Nodes that stand this share of an element's thickness beyond an edge stand over it.
constexpr double just_beyond = 1e-6;

double allowed_beyond(const SurfacePair& pair, const FaceBound& face) {
  return pair.tangential_tolerance.value_or(automatic_beyond * face.radius());
}

bool has_corner(const ContactFace& face, std::uint32_t node) {
  return std::find(face.corners.begin(), face.corners.end(), node) != face.corners.end();
}

}  // namespace

/// A face that a node may touch.
struct NodeFaceContacts::Hit {
  std::uint32_t face = 0, pair = 0;
  FacePoint point;
  PairPenalty penalty;
  double share = 1.0;     ///< of the node's area, where it stands over several faces alike [1]
  double distance = 0.0;  ///< of the node, the middle of a ball, from the face [length]
  double near = 0.0;      ///< gaps up to it may close soon [length]
};

/// The few faces that a node is near to. More than fit are left out, the ones found last.
struct NodeFaceContacts::Hits {
  static constexpr std::size_t most = 16;

  std::array<Hit, most> hits;
  std::size_t n = 0;

  void add(const Hit& hit) {
    if (n < most) hits[n++] = hit;
  }
  auto begin() { return hits.begin(); }
  auto end() { return hits.begin() + static_cast<std::ptrdiff_t>(n); }
};

/// What is known of a node, the faces that it is near to, and the touches of this step so far.
struct NodeFaceContacts::Work {
  Memory memory;
  Hits hits;
  std::vector<Touch> touches;
};

void NodeFaceContacts::find(const ContactScene& scene, std::size_t begin, std::size_t end,
                            std::vector<ContactRecord>& records) {
  std::vector<Touch>& touches = touches_[begin / rows_per_chunk];
  Work work;
  auto known = touches.cbegin();
  for (auto row = static_cast<std::uint32_t>(begin); row < end; ++row) {
    const auto first = known;
    while (known != touches.cend() && known->row == row) ++known;
    work.memory.touches = {first, known};
    // What the other kind of enforcement remembers of the node stays.
    std::copy_if(first, known, std::back_inserter(work.touches),
                 [&](const Touch& touch) { return touch.is_balanced != scene.balances; });
    if (!candidates_.of(row).empty()) find_one(scene, row, work, records);
  }
  std::vector<LostContact>& lost = lost_[begin / rows_per_chunk];
  for (const Touch& touch : touches) {
    if (touch.is_deep != 0 && !std::ranges::binary_search(work.touches, touch.row, {}, &Touch::row))
      lost.push_back({touch.pair, faces_.surface_nodes[touch.row].node, touch.depth});
  }
  touches = std::move(work.touches);
}

void NodeFaceContacts::find_one(const ContactScene& scene, std::uint32_t row, Work& work,
                                std::vector<ContactRecord>& records) const {
  work.hits.n = 0;
  for (const std::uint32_t face : candidates_.of(row)) look_at(scene, row, face, work.memory, work.hits);
  if (work.hits.n > 1) choose(scene, row, work.memory, work.hits);
  for (Hit& hit : work.hits) {
    const PairRule& rule = scene.rules.of_node(hit.pair, row);
    if (scene.dt == 0.0 && hit.point.gap > hit.near && !rule.acts_apart()) continue;
    hit.share *= share_of(scene, row, hit);
    records.push_back(make_record(scene, row, hit));
    ContactRecord& record = records.back();
    if (rule.acts_apart()) {
      record.elastic = work.memory.elastic(record.normal);
      pull_node(*rule.place, make_push(scene, row, hit, record), record);
    }
    if (!record.is_met()) continue;
    if (rule.friction > 0.0 && !record.is_balanced) {
      record.elastic = work.memory.elastic(record.normal);
      add_friction(hit.penalty.stiffness * record.area, rule.slip_limit(record, scene.dt), record);
    }
    work.touches.push_back(make_touch(row, hit, record));
  }
}

NodeFaceContacts::Touch NodeFaceContacts::make_touch(std::uint32_t row, const Hit& hit,
                                                     const ContactRecord& record) const {
  const double thickness =
      std::min(faces_.surface_nodes[row].backing.thickness, faces_.faces[hit.face].backing.thickness);
  const double depth = std::max(0.0, -hit.point.gap);
  return {row,
          record.is_balanced,
          record.normal.cast<float>(),
          record.elastic,
          static_cast<float>(depth),
          depth > deep_share * thickness,
          hit.pair};
}

void NodeFaceContacts::look_at(const ContactScene& scene, std::uint32_t row, std::uint32_t face_index,
                               const Memory& memory, Hits& hits) const {
  const SurfaceNode& node = faces_.surface_nodes[row];
  const ContactFace& face = faces_.faces[face_index];
  const FaceBound& bound = scene.surface.bound(face_index);
  const Eigen::Vector3d x = scene.surface.x(node.node);
  const Eigen::Vector3f closing = bound.velocity() - scene.surface.v(node.node).cast<float>();
  const float mean = closing.dot(bound.normal());
  const double closed = above_zero(mean) * scene.dt;
  const double near = above_zero(mean + bound.stir()) * scene.ahead();
  // Before the first step faces in front of the node count too: it is not inside what it stands in front of.
  Hit hit;
  hit.face = face_index;
  hit.pair = scene.rules.find(node.surface, face.surface);
  const PairRule& rule = scene.rules.of_node(hit.pair, row);
  if (rule.is_balanced != scene.balances) return;
  const double margin =
      scene.balances ? closed_share * std::min(face.backing.thickness, node.backing.thickness) : 0.0;
  const double reach =
      std::max({rule.reach, margin, scene.dt > 0.0 ? near : std::max<double>(near, bound.radius())});
  hit.near = std::max(near, margin);
  const double of_known = memory.touches.empty() ? 0.0 : any_depth;
  const double deepest =
      std::max({rule.pair->normal_tolerance.value_or(face.backing.thickness), 1.5 * closed, of_known});
  const double beyond = allowed_beyond(*rule.pair, bound);
  // Behind the edge of a hollow a node may stand as far beyond it as it is deep.
  const double behind = std::max(0.0f, bound.twist() - bound.height_of(x));
  if (!may_stand_over(x, bound, reach + node.radius, deepest, beyond + behind + node.radius) ||
      has_corner(face, node.node))
    return;
  if (!rule.is_active || rule.law == ContactLaw::tied) return;
  if (rule.law != ContactLaw::sliding && scene.glued.holds_node(row, hit.pair)) return;
  const MovingFace moving = scene.surface.face(face_index);
  const auto point = project_ball(moving.x, moving.is_triangle, x, node.radius);
  if (!point) return;
  hit.point = *point;
  hit.distance = std::abs(point->gap + node.radius) + point->beyond;
  hit.penalty = make_pair_penalty(node.backing, &face.backing, *rule.pair);
  const bool is_known = memory.knows(hit.point.normal);
  hit.penalty.depth = is_known ? any_depth : std::max(hit.penalty.depth, 1.5 * closed);
  if (hit.point.gap > reach || -hit.point.gap > hit.penalty.depth) return;
  if (!comes_from_outside(scene, node, moving, hit, memory.depth(hit.point.normal))) return;
  if (!looks_at(scene, node, hit.point.normal) || !stands_over(scene, face_index, hit)) return;
  const bool may_hang_over = hit.point.edge >= 0 && rule.pair->tangential_tolerance.has_value();
  if ((hit.point.gap < 0.0 || scene.balances) && node.radius == 0.0f && !may_hang_over &&
      is_at_flush_rim(scene, row, face_index, hit.point.normal))
    return;
  hits.add(hit);
}

bool NodeFaceContacts::comes_from_outside(const ContactScene& scene, const SurfaceNode& node,
                                          const MovingFace& face, const Hit& hit, double depth) const {
  // Before the first step nobody knows; what overlaps then is pushed out.
  if (scene.dt == 0.0 || hit.point.gap >= 0.0) return true;
  const Eigen::Vector4d weights = corner_weights(hit.point.xi, hit.point.eta, face.is_triangle);
  const double approach = (face.v * weights - scene.surface.v(node.node)).dot(hit.point.normal) * scene.dt;
  // Beyond the edge of a face it may be outside the body: there it has to come from in front. A spring that
  // holds the node already does not end there, for its force would come and go with all of its depth.
  const bool is_beyond = hit.point.edge >= 0 && hit.point.beyond > just_beyond * node.backing.thickness;
  const double held = scene.balances && is_beyond ? 0.0 : known_depth * depth;
  const double shallow = is_beyond
                             ? just_beyond * node.backing.thickness
                             : std::max(shallow_depth * node.backing.thickness, flush_width(scene, hit.face));
  return hit.point.gap + approach > -std::max(shallow, held);
}

bool NodeFaceContacts::looks_at(const ContactScene& scene, const SurfaceNode& node,
                                const Eigen::Vector3d& normal) const {
  bool has_faces = false;
  for (const std::uint32_t own : faces_.faces_of_node.of(node.node)) {
    if (faces_.faces[own].surface != node.surface) continue;
    if (scene.surface.bound(own).normal().dot(normal.cast<float>()) < static_cast<float>(most_aside))
      return true;
    has_faces = true;
  }
  return !has_faces;
}

bool NodeFaceContacts::stands_over(const ContactScene& scene, std::uint32_t face_index,
                                   const Hit& hit) const {
  if (hit.point.edge < 0) return true;
  const ContactFace& face = faces_.faces[face_index];
  const FaceBound& bound = scene.surface.bound(face_index);
  double allowed = allowed_beyond(*scene.rules[hit.pair].pair, bound);
  // Behind the edge of a hollow there is a wedge that no face stands over.
  const std::size_t n = face.is_triangle() ? 3 : 4, k = static_cast<std::size_t>(hit.point.edge);
  const std::uint32_t a = face.corners[k], b = face.corners[(k + 1) % n];
  for (const std::uint32_t other : faces_.faces_of_node.of(a)) {
    if (other == face_index || !has_corner(faces_.faces[other], b)) continue;
    if (bound.looks_to(scene.surface.bound(other).centre())) allowed += std::max(0.0, -hit.point.gap);
  }
  return hit.point.beyond <= allowed;
}

/// A node right behind an edge or a corner stands over all its faces alike. Choosing one would push it aside,
/// and which one it is would be chance: they share the node. Faces that lie in one plane need not. Returns
/// how many faces, the first ones, share it.
std::size_t NodeFaceContacts::share_edge(double thickness, Hits& hits) {
  constexpr double alike = 1e-6, alike_over_thickness = 1e-4, one_plane = 1.0 - 1e-13;
  const FacePoint& first = hits.hits[0].point;
  const double farthest = (1.0 + alike) * hits.hits[0].distance + alike_over_thickness * thickness;
  std::size_t n = 1;
  for (std::size_t i = 1; i < hits.n; ++i) {
    const FacePoint& point = hits.hits[i].point;
    const double cosine = first.normal.dot(point.normal);
    const bool is_farther = hits.hits[i].distance > farthest;
    if (cosine < same_wall || cosine > one_plane || is_farther) continue;
    std::swap(hits.hits[i], hits.hits[n++]);
  }
  for (std::size_t i = 0; i < n; ++i) hits.hits[i].share = 1.0 / static_cast<double>(n);
  return n;
}

void NodeFaceContacts::choose(const ContactScene& scene, std::uint32_t row, const Memory& memory,
                              Hits& hits) const {
  const bool is_ball = faces_.surface_nodes[row].radius > 0.0f;
  const auto went_in_here = [&](const Hit& hit) { return memory.knows(hit.point.normal); };
  // Faces on the side of the last step first, then the nearest, then those over which the node stands.
  std::stable_sort(hits.begin(), hits.end(), [&](const Hit& a, const Hit& b) {
    const bool a_in = went_in_here(a), b_in = went_in_here(b);
    if (a_in != b_in) return a_in;
    return a.distance < b.distance;
  });
  std::size_t n_chosen = share_edge(faces_.faces[hits.hits[0].face].backing.thickness, hits);
  for (std::size_t i = n_chosen, n_walls = 1; i < hits.n && n_walls < most_walls; ++i) {
    const Hit& hit = hits.hits[i];
    const auto is_other_wall = [&](const Hit& chosen) {
      const FaceBound &wall = scene.surface.bound(chosen.face), &other = scene.surface.bound(hit.face);
      const double cosine = chosen.point.normal.dot(hit.point.normal);
      // Of a hollow: each wall stands in front of the other. A ball fills a narrow one, too.
      return cosine < same_wall && (is_ball || cosine > -same_wall) && wall.looks_to(other.centre()) &&
             other.looks_to(wall.centre());
    };
    if (std::all_of(hits.begin(), hits.begin() + static_cast<std::ptrdiff_t>(n_chosen), is_other_wall))
      hits.hits[n_chosen++] = hit, ++n_walls;
  }
  hits.n = n_chosen;
}

/// The node's share in what both ways of the pair do together. To forces along the gap that only the sum of
/// both ways matters to, half will do; a pull has the traction that its law says on all of the area.
double NodeFaceContacts::share_of(const ContactScene& scene, std::uint32_t row, const Hit& hit) const {
  if (faces_.surface_nodes[row].radius > 0.0f) return 1.0;  // no face's nodes meet balls in turn
  const PairRule& rule = scene.rules.of_node(hit.pair, row);
  if (!rule.acts_apart()) return rule.pair->node_share();
  const NearPlace place{row, hit.face, hit.pair, true, std::max(rule.reach, hit.penalty.depth)};
  const bool is_triangle = faces_.faces[hit.face].is_triangle();
  return share_of_node(scene, candidates_, place, corner_weights(hit.point.xi, hit.point.eta, is_triangle));
}

ContactRecord NodeFaceContacts::make_record(const ContactScene& scene, std::uint32_t row,
                                            const Hit& hit) const {
  const SurfaceNode& node = faces_.surface_nodes[row];
  const ContactFace& face = faces_.faces[hit.face];
  const PairRule& rule = scene.rules[hit.pair];
  ContactRecord record;
  record.pair = hit.pair;
  record.is_swapped = node.surface != rule.pair->first;
  record.first_place = row;
  record.second_place = hit.face;
  record.first.nodes.fill(node.node);
  record.first.weights = Eigen::Vector4d::UnitX();
  record.first.radius = node.radius;
  record.second = {face.corners, corner_weights(hit.point.xi, hit.point.eta, face.is_triangle())};
  record.normal = hit.point.normal;
  record.gap = hit.point.gap;
  push_node(make_push(scene, row, hit, record), record);
  return record;
}

NodePush NodeFaceContacts::make_push(const ContactScene& scene, std::uint32_t row, const Hit& hit,
                                     const ContactRecord& record) const {
  const SurfaceNode& node = faces_.surface_nodes[row];
  const SurfacePair& pair = *scene.rules[hit.pair].pair;
  const double area = hit.share * scene.surface.area_against(node, hit.point.normal);
  const MovingFace moving = scene.surface.face(hit.face);
  const Eigen::Vector3d arm = -static_cast<double>(node.radius) * hit.point.normal;
  const Eigen::Vector3d relative =
      scene.surface.velocity_beside(node.node, arm) - moving.v * record.second.weights;
  const Eigen::Vector3d last = scene.surface.last_velocity_beside(node.node, arm) -
                               scene.surface.last_face(hit.face).v * record.second.weights;
  return {hit.penalty, pair.damping_fraction, area, relative, scene.dt, scene.coming_dt, last};
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/interpenetration_watch.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "contact/mesh/bodies.hpp"
#include "contact/overlap/crossed_sheets.hpp"
#include "contact/overlap/deep_overlaps.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

/// Share of the least thickness that a node may go unseen.
constexpr double unseen_share = 0.25;

/// Depths below this share of a thickness are those of contact that holds.
constexpr double shallow_share = 0.1;

Eigen::Vector3d mean(std::span<const Eigen::Vector3d> points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) sum += point;
  return sum / static_cast<double>(std::max<std::size_t>(points.size(), 1));
}

IndexedVector<ContactNodeIndex, Eigen::Vector3d> places_of(const ContactMoment& moment) {
  IndexedVector<ContactNodeIndex, Eigen::Vector3d> places;
  places.reserve(moment.kinematics.contact_mesh().n_nodes());
  for (const NodeIndex node : moment.kinematics.contact_mesh().mesh_nodes)
    places.emplace_back(moment.coordinates.col(node.value));
  return places;
}

}  // namespace

InterpenetrationWatch::InterpenetrationWatch(const ContactModel& model, const Mesh& mesh,
                                             std::span<const StartOverlap> overlaps)
    : model_(model), mesh_(mesh), of_pair_(model.pairs.size()) {
  const std::vector<std::uint32_t> bodies = find_bodies(mesh);
  has_several_bodies_ = std::ranges::adjacent_find(bodies, std::not_equal_to<>()) != bodies.end();
  for (const StartOverlap& overlap : overlaps) of_pair_[overlap.pair].start_depth = overlap.deepest;
}

bool InterpenetrationWatch::has_moved_far(const ContactMoment& moment) const {
  const IndexedVector<ContactNodeIndex, Eigen::Vector3d> now = places_of(moment);
  const Eigen::Vector3d way = mean(now) - mean(before_);
  const ContactMesh& contact_mesh = moment.kinematics.contact_mesh();
  const auto thickness = [](const SurfaceNode& node) {
    return node.radius > 0.0f ? 2.0 * node.radius : node.penalty_properties.thickness;
  };
  // What is thick may go through what is thin.
  double least = std::numeric_limits<double>::infinity();
  for (const SurfaceNode& node : contact_mesh.surface_nodes) {
    if (thickness(node) > 0.0) least = std::min(least, thickness(node));
  }
  return std::ranges::any_of(contact_mesh.surface_nodes, [&](const SurfaceNode& node) {
    return (now[node.node] - before_[node.node] - way).norm() > unseen_share * least;
  });
}

bool InterpenetrationWatch::is_look_due(const ContactMoment& moment, int n_steps) {
  if (before_.empty()) {
    before_ = places_of(moment);
    n_since_ = 0;
    return false;
  }
  return ++n_since_ % n_steps == 0 && has_moved_far(moment);
}

void InterpenetrationWatch::look(const ContactMoment& moment) {
  if (has_several_bodies_) find_deep(moment);
  if (!before_.empty() && moment.kinematics.contact_mesh().loft.size() > 0) {
    const IndexedVector<ContactNodeIndex, Eigen::Vector3d> now = places_of(moment);
    for (const SheetCrossing& crossing :
         find_crossed_sheets(moment.kinematics.contact_mesh(), moment.rules, before_, now)) {
      const PairRule& rule = moment.rules[crossing.pair];
      if (!rule.is_active || rule.only_ties()) continue;
      Interpenetration& found = of_pair_[crossing.pair];
      if (found.n_crossed++ > 0) continue;
      found.crossed_node = crossing.node.value;
      found.crossed_time = moment.time;
    }
  }
  before_ = {};
  before_ = places_of(moment);
  n_since_ = 0;
}

void InterpenetrationWatch::find_deep(const ContactMoment& moment) {
  const OverlapParts parts = make_overlap_parts(moment.kinematics, mesh_);
  IndexedVector<PairIndex, Interpenetration> seen(of_pair_.size());
  for (const DeepOverlap& overlap : DeepOverlaps(model_, mesh_, parts, moment.alive)
                                        .find(moment.coordinates, moment.kinematics, shallow_share)) {
    // Of shells passages tell: bent ones are lofted over corners of what they touch.
    if (parts.contact_mesh.is_lofted(parts.contact_mesh.faces[overlap.face])) continue;
    const PairRule& rule = moment.rules[overlap.pair];
    if (!rule.is_active || rule.only_ties()) continue;
    Interpenetration& found = seen[overlap.pair];
    ++found.n_nodes;
    if (overlap.depth <= found.depth) continue;
    found.depth = overlap.depth;
    const double own = parts.of_node[overlap.row].half_thickness,
                 other = parts.of_face[overlap.face].half_thickness;
    const double thickness = 2.0 * (own > 0.0 ? std::min(own, other) : other);
    found.share = thickness > 0.0 ? overlap.depth / thickness : 0.0;
    found.node = parts.contact_mesh.mesh_nodes[parts.contact_mesh.surface_nodes[overlap.row].node].value;
  }
  for (const PairIndex i : indices(of_pair_)) {
    Interpenetration& known = of_pair_[i];
    const double beyond = seen[i].depth - known.start_depth;
    if (beyond <= known.depth) continue;
    known.share = seen[i].share * (beyond / seen[i].depth);
    known.depth = beyond;
    known.node = seen[i].node;
    known.n_nodes = seen[i].n_nodes;
    known.time = moment.time;
  }
}

void InterpenetrationWatch::archive(StateArchive& saved) {
  saved.fixed_rows("contact/watch/pairs", of_pair_, [](Interpenetration& found, RowNumbers& row) {
    row(found.start_depth, found.depth, found.share, found.time, found.node, found.n_nodes, found.n_crossed,
        found.crossed_node, found.crossed_time);
  });
  saved.list("contact/watch/places", before_);
  saved.numbers("contact/watch/steps", n_since_);
}

}  // namespace contactsim

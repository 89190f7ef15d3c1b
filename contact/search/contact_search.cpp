// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/contact_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/errors.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

/// How deep behind a face its box reaches, over the thickness of its element: a bit deeper than contact does.
constexpr double depth_share = 0.8;

void include(const Eigen::Vector3d& point, Box& box) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = point[static_cast<Eigen::Index>(i)];
    // A number that is none must not be lost: comparisons with it would leave the box as it was.
    box.lo[i] = value >= box.lo[i] ? box.lo[i] : value;
    box.hi[i] = value <= box.hi[i] ? box.hi[i] : value;
  }
}

Box box_at(const Eigen::Vector3d& point) {
  Box box;
  for (std::size_t i = 0; i < 3; ++i) box.lo[i] = box.hi[i] = point[static_cast<Eigen::Index>(i)];
  return box;
}

void widen(double margin, Box& box) {
  for (std::size_t i = 0; i < 3; ++i) {
    box.lo[i] -= margin;
    box.hi[i] += margin;
  }
}

template <class AnIndex>
double depth_of(std::span<const float> depths, AnIndex i) {
  return depths.empty() ? 0.0 : depths[i.value];
}

}  // namespace

ContactSearch::ContactSearch(const ContactMesh& contact_mesh, const Mesh& mesh, const PairRules& rules,
                             const SearchOptions& search, const DashOptions& dash,
                             std::span<const OptionalIndex<std::uint32_t>> body_of, Ranks& ranks)
    : contact_mesh_(contact_mesh),
      mesh_(mesh),
      rules_(rules),
      is_once_(search.global_search_once),
      ranks_(&ranks),
      length_scaling_(dash.search_length_scaling),
      filter_(contact_mesh, mesh, rules, is_once_, body_of),
      faces_phase_(ranks),
      nodes_phase_(ranks),
      edges_phase_(ranks) {
  for (const PairRule& rule : rules.rules()) {
    const bool is_node_face = rule.pair->formulation == ConstraintFormulation::node_face;
    (is_node_face ? has_node_pairs_ : has_face_pairs_) = true;
    has_small_sliding_ |= rule.pair->behavior == InteractionBehavior::infinitesimal_sliding;
  }
  const auto is_sphere = [](const SurfaceNode& node) { return node.radius > 0.0f; };
  has_node_pairs_ = has_node_pairs_ || std::ranges::any_of(contact_mesh.surface_nodes, is_sphere);
  margins_.set(contact_mesh, mesh, length_scaling_);
  set_activation_distances();
}

void ContactSearch::archive(StateArchive& saved) {
  margins_.archive(n_searches_, saved);
  turned_away_.archive(saved);
  first_partners_.archive(saved);
  filter_.set_first_search(n_searches_ == 0);
  quiet_until_ = 0.0;
}

bool ContactSearch::is_due(const ContactKinematics& kinematics) {
  if (n_searches_ == 0) return true;
  if (is_once_ || !(has_face_pairs_ || has_node_pairs_)) return false;
  if (kinematics.path() < quiet_until_) return false;
  const double room_to_turn = turned_away_.room(kinematics);
  if (room_to_turn < 0.0) return true;
  // Two sides share their margins: one may use up what the other, at rest, does not need.
  const auto used = margins_.used(contact_mesh_, kinematics);
  const bool have_room = std::ranges::all_of(rules_.rules(), [&](const PairRule& rule) {
    const SurfaceIndex first = rule.pair->first, second = rule.pair->second;
    return margins_.has_room(first, used[first], second, used[second]) &&
           margins_.has_room(second, used[second], first, used[first]);
  });
  if (have_room) quiet_until_ = kinematics.path() + std::min(room_to_turn, margins_.room(used));
  return !have_room;
}

void ContactSearch::stop_at(const ContactKinematics& kinematics, const Motion& motion,
                            ContactNodeIndex node) const {
  const NodeIndex index{contact_mesh_.mesh_nodes[node]};
  // Boxes are of single precision.
  constexpr double farthest = 1e38;
  if (motion.dt == 0.0 && !(kinematics.x(node).lpNorm<Eigen::Infinity>() < farthest))
    throw FileError(mesh_.path(),
                    fmt::format("contact at node {} is {:.3g} away from the origin, farther than contact "
                                "searches; its coordinates, or the thickness or radius there, are too large",
                                mesh_.node_id(index), kinematics.x(node).lpNorm<Eigen::Infinity>()));
  throw SolveError(motion.time, fmt::format("node {} moves without bound", mesh_.node_id(index)));
}

void ContactSearch::find_face_pairs(const ContactKinematics& kinematics, const Motion& motion,
                                    std::span<const float> depths, FacePairLists& partners) {
  const auto box_of = [&](FaceIndex face) {
    return face_box(kinematics, face, motion.dt, depth_of(depths, face));
  };
  if (const auto bad = faces_phase_.update(indices(contact_mesh_.faces), box_of)) {
    for (const ContactNodeIndex corner : contact_mesh_.faces[*bad].corners) {
      if (!kinematics.x(corner).allFinite() || !kinematics.v(corner).allFinite())
        stop_at(kinematics, motion, corner);
    }
    stop_at(kinematics, motion, contact_mesh_.faces[*bad].corners[0]);
  }
  if (!has_face_pairs_) return;
  turned_away_.begin(kinematics);
  const auto may_meet = [&](FaceIndex a, FaceIndex b) {
    const OptionalIndex<PairIndex> pair = filter_.pair_of_faces(a, b);
    if (!pair || (filter_.has_to_face(*pair) && turned_away_.are(kinematics, a, b))) return false;
    return filter_.faces_may_meet(*pair, a, b);
  };
  faces_phase_.find_pairs(may_meet, partners);
  keep_first_partners(partners);
}

void ContactSearch::find_node_faces(const ContactKinematics& kinematics, const Motion& motion,
                                    std::span<const float> depths, NodeFaceLists& faces) {
  if (!has_node_pairs_ && !has_eroded_nodes_) return;
  const auto box_of = [&](SurfaceNodeIndex row) {
    return node_box(kinematics, row, motion.dt, depth_of(depths, row));
  };
  if (const auto bad = nodes_phase_.update(indices(contact_mesh_.surface_nodes), box_of))
    stop_at(kinematics, motion, contact_mesh_.surface_nodes[*bad].node);
  nodes_phase_.find_pairs(
      faces_phase_, [this](SurfaceNodeIndex row, FaceIndex face) { return filter_.node_may_meet(row, face); },
      faces);
  keep_first_partners(faces);
}

void ContactSearch::find_edge_pairs(const ContactKinematics& kinematics, const Motion& motion,
                                    std::span<const float> depths, EdgePairLists& partners) {
  const auto box_of = [&](EdgeIndex edge) {
    return edge_box(kinematics, edge, motion.dt, depth_of(depths, edge));
  };
  if (const auto bad = edges_phase_.update(indices(contact_mesh_.edges), box_of))
    stop_at(kinematics, motion, contact_mesh_.edges[*bad].nodes[0]);
  edges_phase_.find_pairs([this](EdgeIndex a, EdgeIndex b) { return filter_.edges_may_meet(a, b); },
                          partners);
}

void ContactSearch::finish(const ContactKinematics& kinematics) {
  ++n_searches_;
  filter_.set_first_search(false);
  turned_away_.finish(kinematics, *ranks_);
  margins_.start_at(contact_mesh_, kinematics);
  quiet_until_ = 0.0;
}

Box ContactSearch::face_box(const ContactKinematics& kinematics, FaceIndex index, double dt,
                            double deep) const {
  const ContactFace& face = contact_mesh_.faces[index];
  const Eigen::Vector3d inward = -std::max(depth_share * face.penalty_properties.thickness, deep) *
                                 kinematics.bound(index).normal().cast<double>();
  Box box = box_at(kinematics.x(face.corners[0]));
  for (const ContactNodeIndex corner : face.corners) {
    const Eigen::Vector3d x = kinematics.x(corner);
    include(x, box);
    include(x - dt * kinematics.v(corner), box);
    include(x + inward, box);
  }
  const double height = contact_mesh_.smooth_faces.extent(index).height;
  widen(margins_.of(index) + 0.5 * activation_distance_[face.surface] + height, box);
  return box;
}

Box ContactSearch::node_box(const ContactKinematics& kinematics, SurfaceNodeIndex row, double dt,
                            double deep) const {
  const ContactNodeIndex node = contact_mesh_.surface_nodes[row].node;
  Box box = box_at(kinematics.x(node));
  include(kinematics.x(node) - dt * kinematics.v(node), box);
  const SurfaceNode& own = contact_mesh_.surface_nodes[row];
  widen(margins_.of(node) + std::max<double>(own.radius, deep) + 0.5 * activation_distance_[own.surface],
        box);
  return box;
}

Box ContactSearch::edge_box(const ContactKinematics& kinematics, EdgeIndex index, double dt,
                            double deep) const {
  const ContactEdge& edge = contact_mesh_.edges[index];
  Box box = box_at(kinematics.x(edge.nodes[0]));
  double margin = 0.0;
  for (const ContactNodeIndex node : edge.nodes) {
    include(kinematics.x(node), box);
    include(kinematics.x(node) - dt * kinematics.v(node), box);
    margin = std::max<double>(margin, margins_.of(node));
  }
  widen(margin + std::max(edge.radius, deep) + 0.5 * activation_distance_[edge.surface], box);
  return box;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/contact_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/errors.hpp"
#include "core/base/state_archive.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

namespace {

/// How deep behind a face its box reaches, over the thickness of its element: a bit deeper than contact does.
constexpr double depth_share = 0.8;

/// Share of a length that single precision loses at most.
constexpr double rounding = 0x1p-24;

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

/// The larger of two numbers; what is not a number stays.
double larger(double most, double value) { return value <= most || std::isnan(most) ? most : value; }

template <class AnIndex>
double depth_of(std::span<const float> depths, AnIndex i) {
  return depths.empty() ? 0.0 : depths[i.value];
}

template <class AnIndex>
bool is_marked(const IndexedVector<AnIndex, std::uint8_t>& marks, AnIndex i) {
  return !marks.empty() && marks[i] != 0;
}

template <class Row>
bool holds(const PairLists<Row, FaceIndex>& lists, Row row, FaceIndex partner) {
  return std::ranges::binary_search(lists.of(row), partner);
}

}  // namespace

ContactSearch::ContactSearch(const ContactMesh& contact_mesh, const Mesh& mesh, const PairRules& rules,
                             const SearchOptions& search, const DashOptions& dash,
                             std::span<const OptionalIndex<std::uint32_t>> body_of)
    : contact_mesh_(contact_mesh),
      mesh_(mesh),
      rules_(rules),
      adjacent_(contact_mesh, mesh),
      body_of_(body_of),
      is_once_(search.global_search_once),
      length_scaling_(dash.search_length_scaling) {
  for (const PairRule& rule : rules.rules()) {
    const bool is_node_face = rule.pair->formulation == ConstraintFormulation::node_face;
    (is_node_face ? has_node_pairs_ : has_face_pairs_) = true;
    has_small_sliding_ |= rule.pair->behavior == InteractionBehavior::infinitesimal_sliding;
    has_to_face_.push_back(has_to_face(rule) ? 1 : 0);
  }
  const auto is_sphere = [](const SurfaceNode& node) { return node.radius > 0.0f; };
  has_node_pairs_ = has_node_pairs_ || std::ranges::any_of(contact_mesh.surface_nodes, is_sphere);
  set_margins();
}

void ContactSearch::archive(StateArchive& saved) {
  saved.numbers("contact/search/last", n_searches_, searched_from_);
  saved.list("contact/search/searched_at", searched_at_);
  turned_away_.archive(saved);
  contactsim::archive("contact/search/first_face_pairs", first_face_partners_, saved);
  contactsim::archive("contact/search/first_node_pairs", first_node_faces_, saved);
  // Most runs have neither, and states of such runs nothing of them.
  const bool has_new = saved.restores() ? saved.has("contact/search/new_faces")
                                        : !is_new_face_.empty() || !is_new_row_.empty();
  if (!has_new) {
    is_new_face_.clear();
    is_new_row_.clear();
    return;
  }
  saved.list("contact/search/new_faces", is_new_face_);
  saved.list("contact/search/new_nodes", is_new_row_);
}

bool ContactSearch::is_due(const ContactKinematics& kinematics) const {
  if (n_searches_ == 0) return true;
  if (is_once_ || !(has_face_pairs_ || has_node_pairs_)) return false;
  if (turned_away_.have_turned(kinematics)) return true;
  // Two sides share their margins: one may use up what the other, at rest, does not need.
  const auto used = used_margins(kinematics);
  return !std::ranges::all_of(rules_.rules(), [&](const PairRule& rule) {
    const SurfaceIndex first = rule.pair->first, second = rule.pair->second;
    return has_room(first, used[first], second, used[second]) &&
           has_room(second, used[second], first, used[first]);
  });
}

bool ContactSearch::has_room(SurfaceIndex first, double first_used, SurfaceIndex second,
                             double second_used) const {
  if (first_used <= 1.0) return true;
  return (first_used - 1.0) * widest_margin_[first] <= (1.0 - second_used) * narrowest_margin_[second];
}

double ContactSearch::used_margin(const ContactKinematics& kinematics, SurfaceNodeIndex row) const {
  const ContactNodeIndex node = contact_mesh_.surface_nodes[row].node;
  const Eigen::Vector3d now = kinematics.x(node) - searched_from_;
  const double moved = (now - searched_at_[node].cast<double>()).norm() + rounding * now.lpNorm<1>();
  return moved / node_margin_[node];
}

IndexedVector<SurfaceIndex, double> ContactSearch::used_margins(const ContactKinematics& kinematics) const {
  // In pieces: all nodes may be of one surface.
  constexpr std::uint32_t rows_per_piece = 2048;
  struct Piece {
    SurfaceIndex surface;
    std::uint32_t begin, end;
    double most = 0.0;
  };
  std::vector<Piece> pieces;
  const SurfaceIndex past{static_cast<std::uint32_t>(contact_mesh_.n_surfaces())};
  for (const SurfaceIndex surface : IndexRange<SurfaceIndex>({}, past)) {
    const auto rows = contact_mesh_.rows_of(surface);
    const std::uint32_t end = (*rows.end()).value;
    for (std::uint32_t i = (*rows.begin()).value; i < end; i += rows_per_piece)
      pieces.push_back({surface, i, std::min(i + rows_per_piece, end)});
  }
  parallel_for_uneven(pieces.size(), threads_for(contact_mesh_.n_nodes()), [&](std::size_t i) {
    Piece& piece = pieces[i];
    for (std::uint32_t row = piece.begin; row < piece.end; ++row) {
      piece.most = larger(piece.most, used_margin(kinematics, {row}));
    }
  });
  IndexedVector<SurfaceIndex, double> used(contact_mesh_.n_surfaces(), 0.0);
  for (const Piece& piece : pieces) {
    used[piece.surface] = larger(used[piece.surface], piece.most);
  }
  return used;
}

template <class Row, class SurfaceOf>
void ContactSearch::keep_first_partners(const IndexedVector<Row, std::uint8_t>& is_new,
                                        const SurfaceOf& surface_of, PairLists<Row, FaceIndex>& first,
                                        PairLists<Row, FaceIndex>& lists) const {
  if (n_searches_ == 0) {
    first = lists;
    return;
  }
  std::uint32_t n = 0, begin = 0;
  for (const Row row : lists.rows()) {
    const std::uint32_t end = lists.begin[row.value + 1];
    for (std::uint32_t k = begin; k < end; ++k) {
      const FaceIndex partner = lists.partner(k);
      const PairRule& rule = rules_[*rules_.find(surface_of(row), contact_mesh_.faces[partner].surface)];
      const bool may_change = rule.pair->behavior != InteractionBehavior::infinitesimal_sliding;
      if (may_change || is_marked(is_new, row) || is_marked(is_new_face_, partner) ||
          holds(first, row, partner))
        lists.partners[n++] = partner.value;
    }
    begin = end;
    lists.begin[row.value + 1] = n;
  }
  lists.partners.resize(n);
}

bool ContactSearch::has_first_partners(PairIndex pair) const {
  const auto has = [&](const auto& lists, const auto& surface_of) {
    for (const auto row : lists.rows()) {
      for (const FaceIndex partner : lists.of(row)) {
        if (rules_.find(surface_of(row), contact_mesh_.faces[partner].surface) == pair) return true;
      }
    }
    return false;
  };
  return has(first_face_partners_, [&](FaceIndex face) { return contact_mesh_.faces[face].surface; }) ||
         has(first_node_faces_,
             [&](SurfaceNodeIndex row) { return contact_mesh_.surface_nodes[row].surface; });
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
  faces_phase_.find_pairs([&](FaceIndex a, FaceIndex b) { return faces_may_meet(kinematics, a, b); },
                          partners);
  if (has_small_sliding_)
    keep_first_partners(
        is_new_face_, [this](FaceIndex face) { return contact_mesh_.faces[face].surface; },
        first_face_partners_, partners);
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
      faces_phase_, [this](SurfaceNodeIndex row, FaceIndex face) { return node_may_meet(row, face); }, faces);
  if (has_small_sliding_)
    keep_first_partners(
        is_new_row_, [this](SurfaceNodeIndex row) { return contact_mesh_.surface_nodes[row].surface; },
        first_node_faces_, faces);
}

void ContactSearch::find_edge_pairs(const ContactKinematics& kinematics, const Motion& motion,
                                    std::span<const float> depths, EdgePairLists& partners) {
  const auto box_of = [&](EdgeIndex edge) {
    return edge_box(kinematics, edge, motion.dt, depth_of(depths, edge));
  };
  if (const auto bad = edges_phase_.update(indices(contact_mesh_.edges), box_of))
    stop_at(kinematics, motion, contact_mesh_.edges[*bad].nodes[0]);
  edges_phase_.find_pairs([this](EdgeIndex a, EdgeIndex b) { return edges_may_meet(a, b); }, partners);
}

void ContactSearch::finish(const ContactKinematics& kinematics) {
  ++n_searches_;
  turned_away_.finish(kinematics);
  searched_at_.resize(contact_mesh_.n_nodes());
  if (contact_mesh_.n_nodes() > 0) searched_from_ = kinematics.x({0});
  for (const ContactNodeIndex i : contact_mesh_.nodes())
    searched_at_[i] = (kinematics.x(i) - searched_from_).cast<float>();
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
  widen(face_margin_[index] + 0.5 * activation_distance_[face.surface] + height, box);
  return box;
}

Box ContactSearch::node_box(const ContactKinematics& kinematics, SurfaceNodeIndex row, double dt,
                            double deep) const {
  const ContactNodeIndex node = contact_mesh_.surface_nodes[row].node;
  Box box = box_at(kinematics.x(node));
  include(kinematics.x(node) - dt * kinematics.v(node), box);
  const SurfaceNode& own = contact_mesh_.surface_nodes[row];
  widen(node_margin_[node] + std::max<double>(own.radius, deep) + 0.5 * activation_distance_[own.surface],
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
    margin = std::max<double>(margin, node_margin_[node]);
  }
  widen(margin + std::max(edge.radius, deep) + 0.5 * activation_distance_[edge.surface], box);
  return box;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/untied_parts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "contact/formulations/near_pairs.hpp"
#include "contact/mesh/mean_edge.hpp"
#include "contact/search/contact_search.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

bool holds(const SurfacePair& pair) { return row_of(*pair.law).holds_at_start; }

/// What of a face, or a node, lies before the other side [length^2].
struct Held {
  double tied = 0.0, before = 0.0;
};

/// Gathers what is held and what is not, pair by pair.
class UntiedGatherer {
 public:
  UntiedGatherer(const ContactKinematics& start, const PairRules& rules,
                 const IndexedVector<PairIndex, double>& reach, double size_share)
      : start_(start),
        contact_mesh_(start.contact_mesh()),
        rules_(rules),
        reach_(reach),
        size_share_(size_share),
        context_{start, rules, nothing_},
        parts_(reach.size()),
        held_faces_(reach.size()),
        held_rows_(reach.size()),
        nodes_(reach.size()) {
    for (const PairIndex i : indices(parts_)) parts_[i].surface = smaller(*rules.rules()[i].pair);
  }

  void add_faces(FaceIndex first, FaceIndex second);
  void add_node(SurfaceNodeIndex row, FaceIndex face);
  UntiedParts take();

 private:
  SurfaceIndex smaller(const SurfacePair& pair) const;
  void note_node(PairIndex pair, SurfaceNodeIndex row, FaceIndex face, double tolerance);

  const ContactKinematics& start_;
  const ContactMesh& contact_mesh_;
  const PairRules& rules_;
  const IndexedVector<PairIndex, double>& reach_;
  double size_share_;
  ConstrainedPairs nothing_;
  ContactStepContext context_;
  UntiedParts parts_;
  IndexedVector<PairIndex, std::map<FaceIndex, Held>> held_faces_;
  IndexedVector<PairIndex, std::map<SurfaceNodeIndex, Held>> held_rows_;
  IndexedVector<PairIndex, std::map<NodeIndex, bool>> nodes_;  // of the mesh: it is held
};

SurfaceIndex UntiedGatherer::smaller(const SurfacePair& pair) const {
  if (pair.is_one_sided) return pair.second;
  const auto area = [&](SurfaceIndex surface) {
    double sum = 0.0;
    for (const FaceIndex i : contact_mesh_.faces_of(surface))
      sum += start_.area(contact_mesh_.faces[i]).norm();
    return sum;
  };
  return area(pair.first) < area(pair.second) ? pair.first : pair.second;
}

/// Nodes stand before the other side where they project inside one of its faces and face it.
void UntiedGatherer::note_node(PairIndex pair, SurfaceNodeIndex row, FaceIndex face, double tolerance) {
  const auto closest = find_closest_point(context_, row, face, reach_[pair]);
  const SurfaceNode& node = contact_mesh_.surface_nodes[row];
  if (!closest || closest->gap < -tolerance || !is_facing(start_, node, closest->normal)) return;
  bool& is_held = nodes_[pair][contact_mesh_.mesh_nodes[node.node]];
  is_held = is_held || std::abs(closest->gap) <= tolerance;
}

void UntiedGatherer::add_faces(FaceIndex first, FaceIndex second) {
  const ContactFace &a = contact_mesh_.faces[first], &b = contact_mesh_.faces[second];
  const PairIndex pair = *rules_.find(a.surface, b.surface);
  if (!holds(*rules_[pair].pair)) return;
  const auto found = find_face_face_points(start_.face(first), start_.face(second));
  if (!found) return;
  const double tolerance = capture_tolerance_of(*rules_[pair].pair, start_.bound(first), size_share_);
  UntiedPart& part = parts_[pair];
  const bool is_first = a.surface == part.surface;
  Held& held = held_faces_[pair][is_first ? first : second];
  found->visit_near(reach_[pair],
                    [&](double area, double gap, const Eigen::Vector4d&, const Eigen::Vector4d&) {
                      if (gap < -tolerance) return;  // the far side of its own body
                      held.before += area;
                      if (std::abs(gap) <= tolerance) {
                        held.tied += area;
                      } else {
                        part.widest_gap = std::max(part.widest_gap, std::abs(gap));
                      }
                    });
  for (const ContactNodeIndex corner : (is_first ? a : b).corners) {
    if (const auto row = contact_mesh_.find_row(corner, part.surface))
      note_node(pair, *row, is_first ? second : first, tolerance);
  }
}

void UntiedGatherer::add_node(SurfaceNodeIndex row, FaceIndex face) {
  const SurfaceNode& node = contact_mesh_.surface_nodes[row];
  const PairIndex pair = *rules_.find(node.surface, contact_mesh_.faces[face].surface);
  UntiedPart& part = parts_[pair];
  if (!holds(*rules_[pair].pair) || node.surface != part.surface) return;
  const auto closest = find_closest_point(context_, row, face, reach_[pair]);
  const double tolerance = capture_tolerance_of(*rules_[pair].pair, start_.bound(face), size_share_);
  if (!closest || closest->gap < -tolerance || !is_facing(start_, node, closest->normal)) return;
  const double area = start_.area_against(node, closest->normal);
  Held& held = held_rows_[pair][row];
  held.before = std::max(held.before, area);
  if (std::abs(closest->gap) <= tolerance) {
    held.tied = std::max(held.tied, area);
  } else {
    part.widest_gap = std::max(part.widest_gap, std::abs(closest->gap));
  }
  note_node(pair, row, face, tolerance);
}

/// What lies behind something that is held is not missing.
UntiedParts UntiedGatherer::take() {
  for (const PairIndex i : indices(parts_)) {
    const auto add = [&](const Held& held, double whole) {
      parts_[i].tied += held.tied;
      parts_[i].untied += std::max(0.0, std::min(held.before, whole) - held.tied);
    };
    for (const auto& [face, held] : held_faces_[i]) add(held, start_.area(contact_mesh_.faces[face]).norm());
    for (const auto& [row, held] : held_rows_[i]) add(held, held.before);
    for (const auto& [node, is_held] : nodes_[i]) {
      if (!is_held) parts_[i].nodes.push_back(node);
    }
  }
  return std::move(parts_);
}

}  // namespace

UntiedParts find_untied_parts(const ContactModel& model, const Mesh& mesh, const DashOptions& dash) {
  if (std::ranges::none_of(model.pairs, holds)) return UntiedParts(model.pairs.size());
  constexpr double times_tolerance = 2.0, edges = 2.0;
  const ContactMesh contact_mesh = make_contact_mesh(model, mesh);
  ContactKinematics start(contact_mesh);
  const Eigen::Matrix3Xd at_rest = Eigen::Matrix3Xd::Zero(3, mesh.n_nodes());
  const Motion motion{0.0, 0.0, mesh.coordinates(), at_rest};
  start.move_nodes(motion);
  start.bound_all();
  SurfacePairs pairs = model.pairs;
  IndexedVector<PairIndex, double> reach(pairs.size(), 0.0);
  for (const PairIndex i : indices(pairs)) {
    if (!holds(pairs[i])) continue;
    const double given = pairs[i].capture_tolerance.value_or(pairs[i].normal_tolerance.value_or(0.0));
    reach[i] = std::max(times_tolerance * given, edges * mean_edge(start, pairs[i]));
    if (pairs[i].search_distance) reach[i] = std::min(reach[i], find_search_distance(start, pairs[i]));
    pairs[i].tracking_distance = reach[i];  // the search reaches as far
  }
  const PairRules rules(pairs, std::vector<ActiveTimes>(pairs.size()), model.surfaces.surfaces.size());
  ContactSearch search(contact_mesh, mesh, rules, {}, dash);
  FacePairLists face_partners;
  NodeFaceLists node_faces;
  search.find_face_pairs(start, motion, {}, face_partners);
  search.find_node_faces(start, motion, {}, node_faces);
  UntiedGatherer gatherer(start, rules, reach, dash.search_length_scaling);
  for (const FaceIndex first : face_partners.rows()) {
    for (const FaceIndex second : face_partners.of(first)) gatherer.add_faces(first, second);
  }
  for (const SurfaceNodeIndex row : node_faces.rows()) {
    for (const FaceIndex face : node_faces.of(row)) gatherer.add_node(row, face);
  }
  return gatherer.take();
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/start_overlaps.hpp"

#include <algorithm>
#include <set>

#include "contact/overlap/deep_overlaps.hpp"
#include "contact/overlap/overlap_detection.hpp"
#include "core/definition/contact.hpp"

namespace contactsim {

namespace {

/// The mesh node with the largest weight of a side.
NodeIndex main_node(const ContactMesh& contact_mesh, const ContactPointSide& side) {
  Eigen::Index k = 0;
  side.weights.maxCoeff(&k);
  return contact_mesh.mesh_nodes[side.nodes[static_cast<std::size_t>(k)]];
}

/// Gathers the overlaps of one pair.
class PairGatherer {
 public:
  PairGatherer(const ContactMesh& contact_mesh, const ContactKinematics& kinematics)
      : faces_(contact_mesh), surface_(kinematics) {}

  void add(const Overlap& overlap) {
    add_nodes(overlap.first);
    const bool is_plane = overlap.second.weights.isZero(0.0);
    if (!is_plane) sides_.insert(overlap.second.nodes);
    if (overlap.depth <= found_.deepest) return;
    found_.deepest = overlap.depth;
    found_.node = main_node(faces_, overlap.first);
    found_.other = is_plane ? std::nullopt : std::optional(main_node(faces_, overlap.second));
    found_.size = is_plane ? 0.0 : size_of(overlap.second.nodes);
  }
  void add(const DeepOverlap& overlap) {
    const SurfaceNode& node = faces_.surface_nodes[overlap.row];
    const auto& corners = faces_.faces[overlap.face].corners;
    const bool is_new = nodes_.insert(faces_.mesh_nodes[node.node]).second;
    sides_.insert(corners);
    if (overlap.is_deep && is_new) ++found_.n_deep;
    if (overlap.depth <= found_.deepest) return;
    found_.deepest = overlap.depth;
    found_.node = faces_.mesh_nodes[node.node];
    found_.other = faces_.mesh_nodes[corners[0]];
    found_.size = size_of(corners);
  }
  std::optional<StartOverlap> take(PairIndex pair) {
    if (found_.deepest == 0.0) return std::nullopt;
    found_.pair = pair;
    found_.n_nodes = static_cast<std::uint32_t>(nodes_.size());
    found_.n_faces = static_cast<std::uint32_t>(sides_.size());
    return found_;
  }

 private:
  void add_nodes(const ContactPointSide& side) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (side.weights[static_cast<Eigen::Index>(k)] > 0.0) nodes_.insert(faces_.mesh_nodes[side.nodes[k]]);
    }
  }

  double size_of(const std::array<ContactNodeIndex, 4>& corners) const {
    const double across = (surface_.x(corners[0]) - surface_.x(corners[2])).norm();
    return std::max(across, (surface_.x(corners[1]) - surface_.x(corners[3])).norm());
  }

  const ContactMesh& faces_;
  const ContactKinematics& surface_;
  StartOverlap found_;
  std::set<NodeIndex> nodes_;
  std::set<std::array<ContactNodeIndex, 4>> sides_;
};

}  // namespace

std::vector<StartOverlap> find_start_overlaps(const ContactModel& model, const Mesh& mesh,
                                              const ContactDefinition& definition) {
  const OverlapParts parts = make_overlap_parts(model, definition, mesh);
  const ShiftedPoints points(parts.contact_mesh, mesh);
  OverlapSearch search(model, definition, mesh, parts);
  search.find(points.renewed());
  const OverlapDetection places(model, parts, search, points, 0.0);
  IndexedVector<PairIndex, PairGatherer> gatherers(model.pairs.size(),
                                                   PairGatherer(parts.contact_mesh, points.renewed()));
  std::set<ContactNodeIndex> reported;  // contact nodes behind faces
  for (const PairIndex p : indices(model.pairs)) {
    places.visit_all(p, [&](const Overlap& overlap) {
      gatherers[p].add(overlap);
      if (overlap.first.is_node()) reported.insert(overlap.first.nodes[0]);
    });
  }
  for (const DeepOverlap& overlap :
       DeepOverlaps(model, mesh, parts).find(mesh.coordinates(), points.renewed())) {
    if (!overlap.is_deep && reported.contains(parts.contact_mesh.surface_nodes[overlap.row].node)) continue;
    gatherers[overlap.pair].add(overlap);
  }
  std::vector<StartOverlap> found;
  for (const PairIndex p : indices(model.pairs)) {
    if (const auto overlap = gatherers[p].take(p)) found.push_back(*overlap);
  }
  return found;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/mark_start_reach.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "contact/geometry/common_plane.hpp"
#include "contact/geometry/edge_edge.hpp"
#include "contact/geometry/face_distance.hpp"
#include "contact/geometry/face_face.hpp"
#include "contact/geometry/node_face.hpp"
#include "contact/mesh/mean_edge.hpp"
#include "contact/search/broad_phase.hpp"

namespace contactsim {

namespace {

Box box_around(const Eigen::Vector3d& lo, const Eigen::Vector3d& hi, double margin) {
  Box box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.lo[i] = lo[static_cast<Eigen::Index>(i)] - margin;
    box.hi[i] = hi[static_cast<Eigen::Index>(i)] + margin;
  }
  return box;
}

/// Looks for what is near of all limited pairs at once.
class ReachMarker {
 public:
  ReachMarker(const ContactKinematics& start, PairRules& rules)
      : start_(start), contact_mesh_(start.contact_mesh()), rules_(rules) {
    reach_.assign(contact_mesh_.n_surfaces(), 0.0);
    for (const PairIndex i : indices(rules.rules())) {
      const SurfacePair& pair = *rules[i].pair;
      if (!pair.search_distance) continue;
      const double distance = find_search_distance(start, pair);
      rules.start_reach().set_distance(i, distance);
      limited_[std::minmax(pair.first, pair.second)].push_back(i);
      for (const SurfaceIndex surface : {pair.first, pair.second})
        reach_[surface] = std::max(reach_[surface], distance);
    }
  }

  void mark_faces();
  void mark_nodes();
  void mark_edges();
  void mark_before_planes(const ContactModel& contact);

 private:
  using Surfaces = std::pair<SurfaceIndex, SurfaceIndex>;

  double distance(PairIndex pair) const { return rules_.start_reach().distance(pair); }
  /// The limited pairs of two surfaces.
  std::span<const PairIndex> pairs_of(SurfaceIndex first, SurfaceIndex second) const {
    const auto found = limited_.find(std::minmax(first, second));
    return found != limited_.end() ? std::span<const PairIndex>(found->second) : std::span<const PairIndex>();
  }
  /// The widest of their distances, < 0 without any [length].
  double widest(SurfaceIndex first, SurfaceIndex second) const {
    double most = -1.0;
    for (const PairIndex pair : pairs_of(first, second)) most = std::max(most, distance(pair));
    return most;
  }
  /// Calls mark(pair) for the limited pairs of two surfaces within whose distance something is.
  template <class Mark>
  void for_each_within(SurfaceIndex first, SurfaceIndex second, double apart, const Mark& mark) {
    for (const PairIndex pair : pairs_of(first, second)) {
      if (apart <= distance(pair)) mark(pair);
    }
  }
  double way_between(FaceIndex first, FaceIndex second) const;
  double way_of_node(const SurfaceNode& node, const ContactFace& face) const;
  double way_of_edges(const ContactEdge& first, const ContactEdge& second) const;
  bool are_opposed(const ContactFace& a, const ContactFace& b) const;
  bool do_cover(FaceIndex first, FaceIndex second) const;
  double height_over(const ContactFace& face, const Eigen::Vector3d& x) const;
  bool is_behind(const ContactFace& face, const Eigen::Vector3d& x) const;
  FaceCorners corners(const ContactFace& face) const;
  void place_faces();

  static constexpr double far = std::numeric_limits<double>::infinity();

  const ContactKinematics& start_;
  const ContactMesh& contact_mesh_;
  PairRules& rules_;
  std::map<Surfaces, std::vector<PairIndex>> limited_;
  IndexedVector<SurfaceIndex, double> reach_;  // [length]
  BroadPhase faces_, nodes_, edges_;
};

FaceCorners ReachMarker::corners(const ContactFace& face) const {
  FaceCorners x;
  for (std::size_t k = 0; k < 4; ++k) x.col(static_cast<Eigen::Index>(k)) = start_.x(face.corners[k]);
  return x;
}

bool ReachMarker::are_opposed(const ContactFace& a, const ContactFace& b) const {
  const Eigen::Vector3d area_a = start_.area(a), area_b = start_.area(b);
  const double facing = facing_limit(std::max(a.sharpness, b.sharpness));
  return area_a.dot(area_b) < facing * area_a.norm() * area_b.norm();
}

/// Whether two faces lie over each other as seen along the normal between them.
bool ReachMarker::do_cover(FaceIndex first, FaceIndex second) const {
  const auto found = find_face_face_points(start_.face(first), start_.face(second));
  return found && found->points.area > 0.0;
}

/// 0 of faces that overlap by no more than the thinner element behind them [length].
double ReachMarker::way_between(FaceIndex first, FaceIndex second) const {
  const ContactFace &a = contact_mesh_.faces[first], &b = contact_mesh_.faces[second];
  if (a.side.element() == b.side.element() || contact_mesh_.share_node(a, b)) return far;
  const bool opposed = are_opposed(a, b);
  if (a.surface == b.surface && !opposed) return far;
  const FaceCorners x = corners(a), y = corners(b);
  const Eigen::Vector3d apart = y.rowwise().mean() - x.rowwise().mean();
  const bool is_behind = apart.dot(start_.area(a)) < 0.0 && apart.dot(start_.area(b)) > 0.0;
  if (is_behind && a.surface == b.surface) return far;  // opposite skins
  const double way = face_distance(x, y);
  const double thinner = std::min(a.penalty_properties.thickness, b.penalty_properties.thickness);
  return is_behind && opposed && way <= thinner && do_cover(first, second) ? 0.0 : way;
}

double ReachMarker::height_over(const ContactFace& face, const Eigen::Vector3d& x) const {
  return (x - corners(face).rowwise().mean()).dot(start_.area(face).normalized());
}

/// Whether a point behind the plane of a face is behind the surface: beyond an edge of the face it is not
/// where it is in front of the next face.
bool ReachMarker::is_behind(const ContactFace& face, const Eigen::Vector3d& x) const {
  const auto point = project_onto_face(corners(face), face.is_triangle(), x);
  if (!point || !point->edge) return true;
  const std::size_t edge = *point->edge, n = face.is_triangle() ? 3 : 4;
  const ContactNodeIndex a = face.corners[edge], b = face.corners[(edge + 1) % n];
  return std::ranges::none_of(contact_mesh_.faces_of_node.of(a), [&](FaceIndex index) {
    const ContactFace& next = contact_mesh_.faces[index];
    return next.surface == face.surface && std::ranges::find(next.corners, b) != next.corners.end() &&
           height_over(next, x) > 0.0;
  });
}

double ReachMarker::way_of_node(const SurfaceNode& node, const ContactFace& face) const {
  if (std::ranges::find(face.corners, node.node) != face.corners.end()) return far;
  const auto own_faces = contact_mesh_.faces_of_node.of(node.node);
  const auto is_opposed = [&](FaceIndex own) { return are_opposed(contact_mesh_.faces[own], face); };
  if (node.surface == face.surface && !own_faces.empty() && std::ranges::none_of(own_faces, is_opposed))
    return far;
  const FaceCorners x = corners(face);
  const double height = height_over(face, start_.x(node.node));
  const double way = std::max(0.0, distance_to_face(start_.x(node.node), x) - node.radius);
  if (height >= 0.0) return way;
  if (node.surface == face.surface) return far;
  const double thinner = std::min(face.penalty_properties.thickness, node.penalty_properties.thickness);
  return way <= thinner && is_behind(face, start_.x(node.node)) ? 0.0 : way;
}

double ReachMarker::way_of_edges(const ContactEdge& first, const ContactEdge& second) const {
  for (const ContactNodeIndex node : first.nodes) {
    if (std::ranges::find(second.nodes, node) != second.nodes.end()) return far;
  }
  const auto segment_of = [&](const ContactEdge& edge) {
    Segment segment;
    segment << start_.x(edge.nodes[0]), start_.x(edge.nodes[1]);
    return segment;
  };
  const Segment a = segment_of(first), b = segment_of(second);
  const EdgePairPoint nearest = nearest_points(a, b);
  const Eigen::Vector3d apart =
      a.col(0) + nearest.s * (a.col(1) - a.col(0)) - b.col(0) - nearest.t * (b.col(1) - b.col(0));
  return std::max(0.0, apart.norm() - first.radius - second.radius);
}

void ReachMarker::place_faces() {
  const auto box_of = [&](FaceIndex i) {
    const ContactFace& face = contact_mesh_.faces[i];
    const FaceCorners x = corners(face);
    return box_around(x.rowwise().minCoeff(), x.rowwise().maxCoeff(),
                      0.5 * std::max(reach_[face.surface], face.penalty_properties.thickness));
  };
  static_cast<void>(faces_.update(indices(contact_mesh_.faces), box_of));
}

void ReachMarker::mark_faces() {
  place_faces();
  FacePairLists near;
  const auto is_near = [&](FaceIndex a, FaceIndex b) {
    const double most = widest(contact_mesh_.faces[a].surface, contact_mesh_.faces[b].surface);
    return most >= 0.0 && way_between(a, b) <= most;
  };
  faces_.find_pairs(is_near, near);
  for (const FaceIndex first : near.rows()) {
    for (const FaceIndex second : near.of(first)) {
      for_each_within(contact_mesh_.faces[first].surface, contact_mesh_.faces[second].surface,
                      way_between(first, second), [&](PairIndex pair) {
                        rules_.start_reach().mark_face(pair, first);
                        rules_.start_reach().mark_face(pair, second);
                      });
    }
  }
}

/// After mark_faces(), whose boxes these nodes meet.
void ReachMarker::mark_nodes() {
  const auto box_of = [&](SurfaceNodeIndex row) {
    const SurfaceNode& node = contact_mesh_.surface_nodes[row];
    const double thickness = 0.5 * node.penalty_properties.thickness;
    const Eigen::Vector3d x = start_.x(node.node);
    return box_around(x, x, node.radius + std::max(0.5 * reach_[node.surface], thickness));
  };
  static_cast<void>(nodes_.update(indices(contact_mesh_.surface_nodes), box_of));
  NodeFaceLists near;
  const auto way = [&](SurfaceNodeIndex row, FaceIndex face) {
    return way_of_node(contact_mesh_.surface_nodes[row], contact_mesh_.faces[face]);
  };
  const auto is_near = [&](SurfaceNodeIndex row, FaceIndex face) {
    const double most = widest(contact_mesh_.surface_nodes[row].surface, contact_mesh_.faces[face].surface);
    return most >= 0.0 && way(row, face) <= most;
  };
  nodes_.find_pairs(faces_, is_near, near);
  for (const SurfaceNodeIndex row : near.rows()) {
    for (const FaceIndex face : near.of(row)) {
      for_each_within(contact_mesh_.surface_nodes[row].surface, contact_mesh_.faces[face].surface,
                      way(row, face), [&](PairIndex pair) {
                        rules_.start_reach().mark_node(pair, row);
                        rules_.start_reach().mark_face(pair, face);
                      });
    }
  }
}

void ReachMarker::mark_edges() {
  const auto box_of = [&](EdgeIndex i) {
    const ContactEdge& edge = contact_mesh_.edges[i];
    const Eigen::Vector3d a = start_.x(edge.nodes[0]), b = start_.x(edge.nodes[1]);
    return box_around(a.cwiseMin(b), a.cwiseMax(b), edge.radius + 0.5 * reach_[edge.surface]);
  };
  static_cast<void>(edges_.update(indices(contact_mesh_.edges), box_of));
  EdgePairLists near;
  const auto way = [&](EdgeIndex a, EdgeIndex b) {
    return way_of_edges(contact_mesh_.edges[a], contact_mesh_.edges[b]);
  };
  const auto is_near = [&](EdgeIndex a, EdgeIndex b) {
    const double most = widest(contact_mesh_.edges[a].surface, contact_mesh_.edges[b].surface);
    return most >= 0.0 && way(a, b) <= most;
  };
  edges_.find_pairs(is_near, near);
  for (const EdgeIndex first : near.rows()) {
    for (const EdgeIndex second : near.of(first)) {
      for_each_within(contact_mesh_.edges[first].surface, contact_mesh_.edges[second].surface,
                      way(first, second), [&](PairIndex pair) {
                        rules_.start_reach().mark_edge(pair, first);
                        rules_.start_reach().mark_edge(pair, second);
                      });
    }
  }
}

void ReachMarker::mark_before_planes(const ContactModel& contact) {
  for (const auto& [surfaces, pairs] : limited_) {
    for (const auto& [with_plane, other] : {surfaces, Surfaces(surfaces.second, surfaces.first)}) {
      for (const std::uint32_t index : contact.surfaces.surfaces[with_plane].analytic_planes) {
        const AnalyticPlane& plane = contact.planes[index];
        const Eigen::Vector3d normal = plane.normal.normalized();
        for (const SurfaceNodeIndex row : contact_mesh_.rows_of(other)) {
          const SurfaceNode& node = contact_mesh_.surface_nodes[row];
          const double gap = (start_.x(node.node) - plane.origin).dot(normal) - node.radius;
          for_each_within(surfaces.first, surfaces.second, gap,
                          [&](PairIndex pair) { rules_.start_reach().mark_node(pair, row); });
        }
      }
    }
  }
}

}  // namespace

void mark_start_reach(const ContactModel& contact, const ContactKinematics& start, PairRules& rules) {
  if (!rules.start_reach().exists()) return;
  ReachMarker marker(start, rules);
  marker.mark_faces();
  marker.mark_nodes();
  marker.mark_edges();
  marker.mark_before_planes(contact);
}

}  // namespace contactsim

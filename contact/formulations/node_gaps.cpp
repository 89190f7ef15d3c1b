// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/node_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/formulations/near_pairs.hpp"
#include "contact/geometry/node_face.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/search/contact_search.hpp"

namespace contactsim {

namespace {

/// A node that stands beside a face by this share of its size counts as over it.
constexpr double beside_face = 0.02;

class NodeGaps {
 public:
  NodeGaps(const ContactKinematics& kinematics, const PairRules& rules, const ContactSearch& search)
      : kinematics_(kinematics),
        contact_mesh_(kinematics.contact_mesh()),
        rules_(rules),
        search_(search),
        gaps_(contact_mesh_.n_nodes(), infinite) {
    for (const PairRule& rule : rules.rules()) {
      if (!rule.is_active) continue;
      begin(rule, rule.pair->first);
      begin(rule, rule.pair->second);
    }
  }

  /// Looks at a node as one of a surface before a face.
  void add(SurfaceNodeIndex row, FaceIndex face_index, double offset) {
    const SurfaceNode& node = contact_mesh_.surface_nodes[row];
    const ContactFace& face = contact_mesh_.faces[face_index];
    const OptionalIndex<PairIndex> pair = rules_.find(node.surface, face.surface);
    if (!pair || !rules_[*pair].is_active) return;
    const SurfacePair& of = *rules_[*pair].pair;
    if (!search_.takes_part(of, node) || !search_.takes_part(of, face)) return;
    const MovingFace moving = kinematics_.face(face_index);
    const SmoothFace* round = contact_mesh_.smooth_faces.find(rules_[*pair].pair->smoothing, face_index);
    const auto point =
        project_sphere(moving.x, moving.is_triangle, round, kinematics_.x(node.node), node.radius);
    if (!point || point->beyond > beside_face * kinematics_.bound(face_index).radius()) return;
    if (!is_facing(kinematics_, node, point->normal)) return;
    take(point->gap - offset, rules_[*pair], node.node);
  }
  void take(double gap, const PairRule& rule, std::uint32_t node) {
    if (std::abs(gap) <= limit(rule, node) && std::abs(gap) < std::abs(gaps_[node])) gaps_[node] = gap;
  }

  std::vector<double> taken() {
    std::ranges::replace(gaps_, infinite, 0.0);
    return std::move(gaps_);
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  double limit(const PairRule& rule, std::uint32_t node) const {
    return rule.pair->tracking_distance.value_or(search_.margin_of(node));
  }
  /// Nothing is known to be nearer than the limit.
  void begin(const PairRule& rule, SurfaceIndex surface) {
    for (const SurfaceNodeIndex row : contact_mesh_.rows_of(surface)) {
      const std::uint32_t node = contact_mesh_.surface_nodes[row].node;
      gaps_[node] = std::min(gaps_[node], limit(rule, node));
    }
  }

  const ContactKinematics& kinematics_;
  const ContactMesh& contact_mesh_;
  const PairRules& rules_;
  const ContactSearch& search_;
  std::vector<double> gaps_;  // [n_contact_nodes] [length]
};

}  // namespace

std::vector<double> find_node_gaps(const ContactKinematics& kinematics, const Mesh& mesh,
                                   const PairRules& rules, const DashOptions& dash, const Motion& motion) {
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  ContactSearch search(contact_mesh, mesh, rules, {}, dash);
  FacePairLists face_partners;
  NodeFaceLists node_faces;
  search.find_face_pairs(kinematics, motion, {}, face_partners);
  search.find_node_faces(kinematics, motion, {}, node_faces);
  NodeGaps gaps(kinematics, rules, search);
  const auto add_corners = [&](FaceIndex of, FaceIndex before) {
    const ContactFace& face = contact_mesh.faces[of];
    const PairIndex pair = *rules.find(face.surface, contact_mesh.faces[before].surface);
    const double offset = rules.gap_offsets().of_faces(pair, of, before);
    for (const std::uint32_t corner : face.corners) {
      const auto row = contact_mesh.find_row(corner, face.surface);
      if (row) gaps.add(*row, before, offset);
    }
  };
  for (const FaceIndex first : face_partners.rows()) {
    for (const FaceIndex second : face_partners.of(first)) {
      add_corners(first, second);
      add_corners(second, first);
    }
  }
  for (const SurfaceNodeIndex row : node_faces.rows()) {
    for (const FaceIndex face : node_faces.of(row)) {
      const PairIndex pair =
          *rules.find(contact_mesh.surface_nodes[row].surface, contact_mesh.faces[face].surface);
      gaps.add(row, face, rules.gap_offsets().of_node(pair, row));
    }
  }
  return gaps.taken();
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/start_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/formulations/near_pairs.hpp"
#include "contact/formulations/penalty.hpp"
#include "contact/geometry/node_face.hpp"
#include "contact/smoothing/smooth_overlap.hpp"

namespace contactsim {

namespace {

std::optional<double> gap_of_node(const ContactKinematics& kinematics, const SurfacePair& pair,
                                  SurfaceNodeIndex row, FaceIndex face) {
  const MovingFace moving = kinematics.face(face);
  const SurfaceNode& node = kinematics.contact_mesh().surface_nodes[row];
  const SmoothFace* round = kinematics.contact_mesh().smooth_faces.find(pair.smoothing, face);
  const auto point =
      project_sphere(moving.x, moving.is_triangle, round, kinematics.x(node.node), node.radius);
  const double depth = make_pair_penalty(node.penalty_properties,
                                         &kinematics.contact_mesh().faces[face].penalty_properties, pair)
                           .depth;
  if (!point || point->edge || -point->gap > depth) return std::nullopt;
  if (!is_facing(kinematics, node, point->normal)) return std::nullopt;
  return point->gap;
}

std::optional<SmoothGap> gap_of_faces(const ContactKinematics& kinematics, const SurfacePair& pair,
                                      FaceIndex first, FaceIndex second) {
  const MovingFace a = kinematics.face(first), b = kinematics.face(second);
  const SmoothFaces& smooth = kinematics.contact_mesh().smooth_faces;
  const SmoothFace *round_a = smooth.find(pair.smoothing, first),
                   *round_b = smooth.find(pair.smoothing, second);
  if (round_a != nullptr || round_b != nullptr) {
    const SmoothPatch patch_a(a, round_a), patch_b(b, round_b);
    return find_smooth_gap({patch_a, patch_b});
  }
  const auto found = find_face_face_points(a, b);
  if (!found) return std::nullopt;
  SmoothGap gap{0.0, std::numeric_limits<double>::infinity(), found->points.area};
  for (const OverlapBatch& batch : found->points.batches()) {
    const auto is_used = batch.weight > 0.0;
    gap.smallest = std::min(gap.smallest, is_used.select(batch.gap, gap.smallest).minCoeff());
    gap.mean += is_used.select(batch.weight * batch.gap, 0.0).sum();
  }
  gap.mean /= gap.area;
  return gap;
}

}  // namespace

std::optional<StartGap> find_start_gap(const ContactKinematics& kinematics, const SurfacePair& pair,
                                       FaceIndex first, FaceIndex second) {
  constexpr double negligible_share = 1e-6;  // of the smaller face: slivers beside faces that match
  const auto found = gap_of_faces(kinematics, pair, first, second);
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  const auto area_of = [&](FaceIndex face) { return kinematics.area(contact_mesh.faces[face]).norm(); };
  if (!found || !(found->area > negligible_share * std::min(area_of(first), area_of(second))))
    return std::nullopt;
  const StartGap gap{first.value, {}, found->mean, found->smallest, found->area};
  const double depth = make_pair_penalty(contact_mesh.faces[first].penalty_properties,
                                         &contact_mesh.faces[second].penalty_properties, pair)
                           .depth;
  const bool is_contact = -gap.smallest <= depth && -gap.smallest <= std::sqrt(gap.area);
  return is_contact ? std::optional(gap) : std::nullopt;
}

std::optional<StartGap> find_start_gap(const ContactKinematics& kinematics, const PairRules& rules,
                                       SurfaceNodeIndex row, IndexView<FaceIndex> faces) {
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  std::optional<StartGap> nearest;
  for (const FaceIndex face : faces) {
    const PairIndex pair =
        *rules.find(contact_mesh.surface_nodes[row].surface, contact_mesh.faces[face].surface);
    const auto gap = gap_of_node(kinematics, *rules[pair].pair, row, face);
    if (!gap || (nearest && std::abs(*gap) >= std::abs(nearest->mean))) continue;
    nearest = StartGap{row.value, pair, *gap, *gap, contact_mesh.surface_nodes[row].area};
  }
  return nearest;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/node_face/node_areas.hpp"

#include <algorithm>
#include <cmath>

#include "contact/geometry/common_plane.hpp"
#include "contact/geometry/smooth_step.hpp"

namespace contactsim {

namespace {

constexpr int n_corrections = 3;

/// What touches is not lost.
constexpr double min_factor = 1e-3;

bool goes_both_ways(const ContactStepContext& context, const ContactPoint& contact_point) {
  if (contact_point.is_balanced && !contact_point.is_met()) return false;
  if (!(contact_point.area > 0.0) || contact_point.first.radius > 0.0 || contact_point.is_held_apart)
    return false;
  return !context.rules[contact_point.pair].pair->is_one_sided &&
         !context.rules.of_node(contact_point.pair, contact_point.row()).acts_apart();
}

/// Whether a face has no smooth neighbour beyond one of its edges.
bool is_border(const ContactStepContext& context, FaceIndex index, std::size_t edge) {
  constexpr float smooth = 0.7f;
  const ContactMesh& contact_mesh = context.kinematics.contact_mesh();
  const ContactFace& face = contact_mesh.faces[index];
  const ContactNodeIndex a = face.corners[edge], b = face.corners[(edge + 1) % (face.is_triangle() ? 3 : 4)];
  return std::ranges::none_of(contact_mesh.faces_of_node.of(a), [&](FaceIndex other) {
    const ContactFace& beyond = contact_mesh.faces[other];
    return other != index && beyond.surface == face.surface &&
           std::ranges::find(beyond.corners, b) != beyond.corners.end() &&
           context.kinematics.bound(other).normal().dot(context.kinematics.bound(index).normal()) > smooth;
  });
}

/// How far a contact point is inside the border of the surface that its face is of, over the node's width;
/// 1 at most.
double inside_border(const ContactStepContext& context, const ContactPoint& contact_point, double width) {
  const ContactFace& face = context.kinematics.contact_mesh().faces[contact_point.second_face()];
  const FaceCorners x = context.kinematics.face(contact_point.second_face()).x;
  const Eigen::Vector3d point = x * contact_point.second.weights;
  const std::size_t n = face.is_triangle() ? 3 : 4;
  double least = 1.0;
  for (std::size_t k = 0; k < n; ++k) {
    if (!is_border(context, contact_point.second_face(), k)) continue;
    const Eigen::Vector3d from = x.col(static_cast<Eigen::Index>(k));
    const Eigen::Vector3d along = x.col(static_cast<Eigen::Index>((k + 1) % n)) - from;
    const double distance = contact_point.normal.cross(along).normalized().dot(point - from);
    least = std::min(least, std::max(0.0, distance / width));
  }
  return smooth_step(least);
}

void scale(double factor, ContactPoint& contact_point) {
  contact_point.area *= factor;
  contact_point.stiffness *= factor;
  contact_point.scale_forces(factor);
}

}  // namespace

/// Whether all nodes of the node's own faces that are turned towards the other side have contact points.
bool NodeAreas::is_covered(const ContactStepContext& context, const ContactPoint& contact_point) const {
  const ContactMesh& contact_mesh = context.kinematics.contact_mesh();
  const SurfaceNode& node = contact_mesh.surface_nodes[contact_point.row()];
  for (const FaceIndex own : contact_mesh.faces_of_node.of(node.node)) {
    const ContactFace& face = contact_mesh.faces[own];
    if (face.surface != node.surface) continue;
    if (!(context.kinematics.bound(own).normal().cast<double>().dot(contact_point.normal) <
          facing_limit(face.sharpness)))
      continue;
    for (const ContactNodeIndex corner : face.corners) {
      if (wanted_[corner] == 0.0) return false;
    }
  }
  return true;
}

/// A node of the finer side stands for most of its area, one of the coarser side leaves it to them. A node
/// that the border of the other side passes comes in little by little where others can take its share.
void NodeAreas::set_first_areas(const ContactStepContext& context,
                                std::span<const ContactPoint> contact_points) {
  for (std::size_t i = 0; i < both_ways_.size(); ++i) {
    const ContactPoint& contact_point = contact_points[both_ways_[i]];
    double other = 0.0, weight = 0.0, covered = 0.0;
    for (Eigen::Index k = 0; k < 4; ++k) {
      const ContactNodeIndex corner = contact_point.second.nodes[static_cast<std::size_t>(k)];
      const double of_corner = wanted_[corner];
      if (of_corner == 0.0) continue;
      const double share = std::max(0.0, contact_point.second.weights[k]);
      other += share * of_corner;
      weight += share;
      if (is_covered_[corner] != 0) covered += share;
    }
    const double own = wanted_[contact_point.first.nodes[0]];
    if (weight > 0.0) areas_[i] *= 2.0 * other / (weight * own + other);
    if (is_covered_[contact_point.first.nodes[0]] != 0 || !(covered > 0.0)) continue;
    areas_[i] *= 1.0 - std::min(covered, 1.0) * (1.0 - inside_border(context, contact_point, std::sqrt(own)));
  }
}

void NodeAreas::sum_areas(std::span<const ContactPoint> contact_points) {
  for (const std::uint32_t i : both_ways_) {
    found_[contact_points[i].first.nodes[0]] = 0.0;
    for (const ContactNodeIndex node : contact_points[i].second.nodes) found_[node] = 0.0;
  }
  for (std::size_t i = 0; i < both_ways_.size(); ++i) {
    const ContactPoint& contact_point = contact_points[both_ways_[i]];
    found_[contact_point.first.nodes[0]] += areas_[i];
    for (std::size_t k = 0; k < 4; ++k)
      found_[contact_point.second.nodes[k]] +=
          areas_[i] * contact_point.second.weights[static_cast<Eigen::Index>(k)];
  }
}

void NodeAreas::correct(std::span<const ContactPoint> contact_points) {
  // The mean of the ratios alone converges slowly, its square swings.
  const auto faster = [](double ratio) { return ratio * std::sqrt(ratio); };
  const auto ratio_of = [&](ContactNodeIndex node) {
    return is_covered_[node] != 0 && found_[node] > 0.0 ? wanted_[node] / found_[node] : 1.0;
  };
  for (std::size_t i = 0; i < both_ways_.size(); ++i) {
    const ContactPoint& contact_point = contact_points[both_ways_[i]];
    double ratio = ratio_of(contact_point.first.nodes[0]);
    for (std::size_t k = 0; k < 4; ++k)
      ratio += contact_point.second.weights[static_cast<Eigen::Index>(k)] *
               ratio_of(contact_point.second.nodes[k]);
    areas_[i] *= faster(std::max(0.0, 0.5 * ratio));
  }
}

void NodeAreas::share_out(const ContactStepContext& context, std::span<ContactPoint> contact_points) {
  both_ways_.clear();
  areas_.clear();
  const std::size_t n_nodes = context.kinematics.contact_mesh().n_nodes();
  wanted_.assign(n_nodes, 0.0);
  found_.resize(n_nodes);
  is_covered_.assign(n_nodes, 0);
  for (std::uint32_t i = 0; i < contact_points.size(); ++i) {
    if (!goes_both_ways(context, contact_points[i])) continue;
    both_ways_.push_back(i);
    areas_.push_back(contact_points[i].area);
    wanted_[contact_points[i].first.nodes[0]] +=
        contact_points[i].area / context.rules[contact_points[i].pair].pair->node_share();
  }
  if (both_ways_.empty()) return;
  for (const std::uint32_t i : both_ways_)
    is_covered_[contact_points[i].first.nodes[0]] = is_covered(context, contact_points[i]) ? 1 : 0;
  set_first_areas(context, contact_points);
  for (int i = 0; i < n_corrections; ++i) {
    sum_areas(contact_points);
    correct(contact_points);
  }
  for (std::size_t i = 0; i < both_ways_.size(); ++i)
    scale(std::max(areas_[i] / contact_points[both_ways_[i]].area, min_factor),
          contact_points[both_ways_[i]]);
}

}  // namespace contactsim

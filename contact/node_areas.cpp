// SPDX-License-Identifier: BSD-3-Clause
#include "contact/node_areas.hpp"

#include <algorithm>
#include <cmath>

#include "contact/common_plane.hpp"

namespace contactsim {

namespace {

constexpr int n_corrections = 3;

/// What touches is not lost.
constexpr double least_factor = 1e-3;

bool goes_both_ways(const ContactScene& scene, const ContactRecord& record) {
  if (record.is_balanced && !record.is_met()) return false;
  if (!(record.area > 0.0) || record.first.radius > 0.0 || record.is_held_apart) return false;
  return !scene.rules[record.pair].pair->is_one_sided &&
         !scene.rules.of_node(record.pair, record.first_place).acts_apart();
}

/// Whether a face has no smooth neighbour beyond one of its edges.
bool is_border(const ContactScene& scene, std::uint32_t index, std::size_t edge) {
  constexpr float smooth = 0.7f;
  const ContactFaces& faces = scene.surface.faces();
  const ContactFace& face = faces.faces[index];
  const std::uint32_t a = face.corners[edge], b = face.corners[(edge + 1) % (face.is_triangle() ? 3 : 4)];
  return std::ranges::none_of(faces.faces_of_node.of(a), [&](std::uint32_t other) {
    const ContactFace& beyond = faces.faces[other];
    return other != index && beyond.surface == face.surface &&
           std::ranges::find(beyond.corners, b) != beyond.corners.end() &&
           scene.surface.bound(other).normal().dot(scene.surface.bound(index).normal()) > smooth;
  });
}

/// How far a contact point is inside the border of the surface that its face is of, over the node's width;
/// 1 at most.
double inside_border(const ContactScene& scene, const ContactRecord& record, double width) {
  const ContactFace& face = scene.surface.faces().faces[record.second_place];
  const FaceCorners x = scene.surface.face(record.second_place).x;
  const Eigen::Vector3d point = x * record.second.weights;
  const std::size_t n = face.is_triangle() ? 3 : 4;
  double least = 1.0;
  for (std::size_t k = 0; k < n; ++k) {
    if (!is_border(scene, record.second_place, k)) continue;
    const Eigen::Vector3d from = x.col(static_cast<Eigen::Index>(k));
    const Eigen::Vector3d along = x.col(static_cast<Eigen::Index>((k + 1) % n)) - from;
    const double distance = record.normal.cross(along).normalized().dot(point - from);
    least = std::min(least, std::max(0.0, distance / width));
  }
  return least * least * (3.0 - 2.0 * least);
}

void scale(double factor, ContactRecord& record) {
  record.area *= factor;
  record.force *= factor;
  record.tangential *= factor;
  record.stiffness *= factor;
  record.dissipated *= factor;
  record.damped *= factor;
  record.beyond_spring *= factor;
}

}  // namespace

/// Whether all nodes of the node's own faces that are turned towards the other side have contact points.
bool NodeAreas::is_covered(const ContactScene& scene, const ContactRecord& record) const {
  const ContactFaces& faces = scene.surface.faces();
  const SurfaceNode& node = faces.surface_nodes[record.first_place];
  for (const std::uint32_t own : faces.faces_of_node.of(node.node)) {
    const ContactFace& face = faces.faces[own];
    if (face.surface != node.surface) continue;
    if (!(scene.surface.bound(own).normal().cast<double>().dot(record.normal) < most_aside)) continue;
    for (const std::uint32_t corner : face.corners) {
      if (wanted_[corner] == 0.0) return false;
    }
  }
  return true;
}

/// A node of the finer side stands for most of its area, one of the coarser side leaves it to them. A node
/// that the border of the other side passes comes in little by little where others can take its share.
void NodeAreas::set_first_areas(const ContactScene& scene, std::span<const ContactRecord> records) {
  for (std::size_t i = 0; i < both_ways_.size(); ++i) {
    const ContactRecord& record = records[both_ways_[i]];
    double other = 0.0, weight = 0.0, covered = 0.0;
    for (Eigen::Index k = 0; k < 4; ++k) {
      const std::uint32_t corner = record.second.nodes[static_cast<std::size_t>(k)];
      const double of_corner = wanted_[corner];
      if (of_corner == 0.0) continue;
      const double share = std::max(0.0, record.second.weights[k]);
      other += share * of_corner;
      weight += share;
      if (is_covered_[corner] != 0) covered += share;
    }
    const double own = wanted_[record.first.nodes[0]];
    if (weight > 0.0) areas_[i] *= 2.0 * other / (weight * own + other);
    if (is_covered_[record.first.nodes[0]] != 0 || !(covered > 0.0)) continue;
    areas_[i] *= 1.0 - std::min(covered, 1.0) * (1.0 - inside_border(scene, record, std::sqrt(own)));
  }
}

void NodeAreas::sum_areas(std::span<const ContactRecord> records) {
  for (const std::uint32_t i : both_ways_) {
    found_[records[i].first.nodes[0]] = 0.0;
    for (const std::uint32_t node : records[i].second.nodes) found_[node] = 0.0;
  }
  for (std::size_t i = 0; i < both_ways_.size(); ++i) {
    const ContactRecord& record = records[both_ways_[i]];
    found_[record.first.nodes[0]] += areas_[i];
    for (std::size_t k = 0; k < 4; ++k)
      found_[record.second.nodes[k]] += areas_[i] * record.second.weights[static_cast<Eigen::Index>(k)];
  }
}

void NodeAreas::correct(std::span<const ContactRecord> records) {
  // The mean of the ratios alone converges slowly, its square swings.
  const auto faster = [](double ratio) { return ratio * std::sqrt(ratio); };
  const auto ratio_of = [&](std::uint32_t node) {
    return is_covered_[node] != 0 && found_[node] > 0.0 ? wanted_[node] / found_[node] : 1.0;
  };
  for (std::size_t i = 0; i < both_ways_.size(); ++i) {
    const ContactRecord& record = records[both_ways_[i]];
    double ratio = ratio_of(record.first.nodes[0]);
    for (std::size_t k = 0; k < 4; ++k)
      ratio += record.second.weights[static_cast<Eigen::Index>(k)] * ratio_of(record.second.nodes[k]);
    areas_[i] *= faster(std::max(0.0, 0.5 * ratio));
  }
}

void NodeAreas::share_out(const ContactScene& scene, std::span<ContactRecord> records) {
  both_ways_.clear();
  areas_.clear();
  const std::size_t n_nodes = scene.surface.faces().n_nodes();
  wanted_.assign(n_nodes, 0.0);
  found_.resize(n_nodes);
  is_covered_.assign(n_nodes, 0);
  for (std::uint32_t i = 0; i < records.size(); ++i) {
    if (!goes_both_ways(scene, records[i])) continue;
    both_ways_.push_back(i);
    areas_.push_back(records[i].area);
    wanted_[records[i].first.nodes[0]] += records[i].area / scene.rules[records[i].pair].pair->node_share();
  }
  if (both_ways_.empty()) return;
  for (const std::uint32_t i : both_ways_)
    is_covered_[records[i].first.nodes[0]] = is_covered(scene, records[i]) ? 1 : 0;
  set_first_areas(scene, records);
  for (int i = 0; i < n_corrections; ++i) {
    sum_areas(records);
    correct(records);
  }
  for (std::size_t i = 0; i < both_ways_.size(); ++i)
    scale(std::max(areas_[i] / records[both_ways_[i]].area, least_factor), records[both_ways_[i]]);
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/deep_overlaps.hpp"

#include <algorithm>
#include <cmath>

#include "contact/bodies.hpp"
#include "contact/broad_phase.hpp"
#include "contact/node_face.hpp"
#include "contact/point_in_solid.hpp"
#include "core/threads.hpp"

namespace contactsim {

namespace {

constexpr std::uint32_t none = 0xffffffff;

/// Shallower than this share of a face's size a node lies on the face.
constexpr double smallest_share = 1e-6;

/// Faces whose normal has a greater cosine with that of the node's surface look the same way.
constexpr double same_way_cosine = 0.25;

Box empty_box() {
  constexpr double far = std::numeric_limits<double>::infinity();
  return {{far, far, far}, {-far, -far, -far}};
}

void add(const Eigen::Vector3d& x, Box& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    box.lo[k] = std::min(box.lo[k], x[static_cast<Eigen::Index>(k)]);
    box.hi[k] = std::max(box.hi[k], x[static_cast<Eigen::Index>(k)]);
  }
}

bool is_solid(const Mesh& mesh, ElementIndex element) {
  return topology(mesh.blocks()[mesh.block_of(element)].shape).family == Family::solid;
}

}  // namespace

DeepOverlaps::DeepOverlaps(const ContactModel& model, const Mesh& mesh, const OverlapParts& parts)
    : mesh_(mesh),
      parts_(parts),
      rules_(model.pairs, std::vector<ActiveTimes>(model.pairs.size()), model.surfaces.surfaces.size()),
      bodies_(find_bodies(mesh)),
      number_of_body_(mesh.n_nodes(), none) {
  for (const ContactFace& face : faces().faces) {
    if (faces().is_lofted(face) || !is_solid(mesh, face.side.element())) continue;
    std::uint32_t& number = number_of_body_[body_of(face)];
    if (number != none) continue;
    number = 0;
    solid_bodies_.push_back(body_of(face));
  }
  std::ranges::sort(solid_bodies_);
  for (std::uint32_t i = 0; i < solid_bodies_.size(); ++i) number_of_body_[solid_bodies_[i]] = i;
}

/// The solids of the bodies that meet the boxes of what may lie in them.
///   boxes  of each body [n_solid_bodies]
std::vector<ElementIndex> DeepOverlaps::elements_near(const Eigen::Matrix3Xd& coordinates,
                                                      std::span<const Box> boxes) const {
  std::vector<ElementIndex> near;
  for (const ElementBlock& block : mesh_.blocks()) {
    if (topology(block.shape).family != Family::solid) continue;
    for (std::uint32_t e = 0; e < block.n_elements; ++e) {
      const auto nodes = block.element_nodes(e);
      const std::uint32_t body = number_of_body_[bodies_[nodes[0].value]];
      if (body == none || boxes[body].lo[0] > boxes[body].hi[0]) continue;
      Box own = empty_box();
      for (const NodeIndex node : nodes) add(coordinates.col(node.value), own);
      if (do_overlap(own, boxes[body])) near.push_back({block.first_element.value + e});
    }
  }
  return near;
}

std::vector<DeepOverlaps::Inside> DeepOverlaps::find_inside(const Eigen::Matrix3Xd& coordinates,
                                                            const MovingSurface& surface) const {
  const auto n_rows = static_cast<std::uint32_t>(faces().surface_nodes.size());
  if (n_rows == 0 || solid_bodies_.empty()) return {};
  const auto box_of_row = [&](std::uint32_t row) {
    Box box = empty_box();
    add(surface.x(faces().surface_nodes[row].node), box);
    return box;
  };
  std::vector<Box> body_boxes(solid_bodies_.size(), empty_box());
  for (Eigen::Index i = 0; i < coordinates.cols(); ++i) {
    const std::uint32_t number = number_of_body_[bodies_[static_cast<std::size_t>(i)]];
    if (number != none) add(coordinates.col(i), body_boxes[number]);
  }
  BroadPhase rows, around, solids;
  if (rows.update(n_rows, box_of_row) || around.update(body_boxes)) return {};
  PairLists near;
  rows.find_pairs(
      around, [&](std::uint32_t row, std::uint32_t body) { return body_of_row(row) != solid_bodies_[body]; },
      near);
  std::vector<Box> boxes(solid_bodies_.size(), empty_box());
  for (std::uint32_t row = 0; row < n_rows; ++row) {
    for (const std::uint32_t body : near.of(row))
      add(surface.x(faces().surface_nodes[row].node), boxes[body]);
  }
  const std::vector<ElementIndex> elements = elements_near(coordinates, boxes);
  if (elements.empty()) return {};
  const auto box_of_element = [&](std::uint32_t i) {
    Box box = empty_box();
    for (const NodeIndex node : mesh_.element_nodes(elements[i])) add(coordinates.col(node.value), box);
    return box;
  };
  if (solids.update(static_cast<std::uint32_t>(elements.size()), box_of_element)) return {};
  const auto is_inside = [&](std::uint32_t row, std::uint32_t i) {
    const auto nodes = mesh_.element_nodes(elements[i]);
    if (bodies_[nodes[0].value] == body_of_row(row)) return false;
    const Topology& shape = topology(mesh_.blocks()[mesh_.block_of(elements[i])].shape);
    return is_in_solid(coordinates, nodes, shape, surface.x(faces().surface_nodes[row].node));
  };
  rows.find_pairs(solids, is_inside, near);
  std::vector<Inside> inside;
  for (std::uint32_t row = 0; row < n_rows; ++row) {
    for (const std::uint32_t i : near.of(row)) {
      const std::uint32_t body = number_of_body_[bodies_[mesh_.element_nodes(elements[i])[0].value]];
      const bool is_known = !inside.empty() && inside.back().row == row && inside.back().body == body;
      if (!is_known) inside.push_back({row, body});
    }
  }
  return inside;
}

std::optional<DeepOverlap> DeepOverlaps::find_way_out(const MovingSurface& surface, const Inside& inside,
                                                      const PairLists& faces_of_body) const {
  const SurfaceNode& node = faces().surface_nodes[inside.row];
  const Eigen::Vector3d point = surface.x(node.node);
  const OverlapNode& own = parts_.of_node[inside.row];
  // A sheet or a ball may go out either way.
  const bool has_normal = !parts_.is_lofted(node) && own.normal.norm() > smallest_share * own.size * own.size;
  std::optional<DeepOverlap> best;
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t index : faces_of_body.of(inside.body)) {
    const ContactFace& face = faces().faces[index];
    const std::uint32_t pair = rules_.find(node.surface, face.surface);
    if (pair == PairRules::none) continue;
    FaceCorners x;
    for (std::size_t k = 0; k < 4; ++k) x.col(static_cast<Eigen::Index>(k)) = surface.x(face.corners[k]);
    const Eigen::Vector3d middle = 0.5 * (x.col(0) + x.col(2));
    if ((point - middle).norm() - (x.colwise() - middle).colwise().norm().maxCoeff() > least) continue;
    const auto foot = project_onto_face(x, face.is_triangle(), point);
    if (!foot) continue;
    const double cosine = has_normal ? own.normal.dot(foot->normal) / own.normal.norm() : -1.0;
    if (cosine > same_way_cosine) continue;
    if (std::hypot(foot->gap, foot->beyond) <= smallest_share * parts_.of_face[index].size)
      return std::nullopt;
    if (foot->gap > 0.0) continue;
    const double cost = std::hypot(foot->gap, foot->beyond) * (1.0 + 2.0 * (1.0 + cosine));
    if (cost >= least) continue;
    least = cost;
    const double depth = static_cast<double>(node.radius) - foot->gap;
    best = DeepOverlap{pair, inside.row, index, depth, foot->normal, false};
  }
  if (!best || !(best->depth > smallest_share * parts_.of_face[best->face].size)) return std::nullopt;
  const double own_reach = own.reach > 0.0 ? own.reach : std::numeric_limits<double>::infinity();
  best->is_deep = best->depth > std::min(own_reach, parts_.of_face[best->face].reach);
  return best;
}

std::vector<DeepOverlap> DeepOverlaps::find(const Eigen::Matrix3Xd& coordinates,
                                            const MovingSurface& surface) const {
  const std::vector<Inside> inside = find_inside(coordinates, surface);
  if (inside.empty()) return {};
  const PairLists faces_of_body = list_by_row(solid_bodies_.size(), [&](const auto& take) {
    for (std::uint32_t i = 0; i < faces().faces.size(); ++i) {
      const std::uint32_t number = number_of_body_[body_of(faces().faces[i])];
      if (number != none && !faces().is_lofted(faces().faces[i])) take(number, i);
    }
  });
  std::vector<std::optional<DeepOverlap>> ways(inside.size());
#pragma omp parallel for schedule(dynamic, 16) num_threads(threads_for(inside.size() * 100))
  for (std::size_t i = 0; i < inside.size(); ++i) ways[i] = find_way_out(surface, inside[i], faces_of_body);
  std::vector<DeepOverlap> found;
  for (const auto& way : ways) {
    if (way) found.push_back(*way);
  }
  return found;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/deep_overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "contact/geometry/node_face.hpp"
#include "contact/geometry/point_in_solid.hpp"
#include "contact/overlap/point_box.hpp"
#include "contact/search/broad_phase.hpp"
#include "contact/search/shell_sides.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

namespace {

/// Shallower than this share of a face's size a node lies on the face.
constexpr double smallest_share = 1e-6;

/// Faces whose normal has a greater cosine with that of the node's surface look the same way.
constexpr double same_way_cosine = 0.25;

/// Whether a point lies in a box, or as near to it as rounding may have it.
bool is_near(const Box& box, const Eigen::Vector3d& x) {
  constexpr double round_off = 1e-6;
  for (std::size_t k = 0; k < 3; ++k) {
    const double lo = box.lo[k], hi = box.hi[k], at = x[static_cast<Eigen::Index>(k)];
    const double margin = round_off * std::max(std::abs(lo), std::abs(hi));
    if (!(lo - margin <= at && at <= hi + margin)) return false;
  }
  return true;
}

}  // namespace

DeepOverlaps::DeepOverlaps(const ContactModel& model, const Mesh& mesh, const OverlapParts& parts,
                           std::span<const std::uint8_t> alive)
    : mesh_(mesh),
      parts_(parts),
      volumes_(mesh, parts.contact_mesh, alive),
      rules_(model.pairs, std::vector<ActiveTimes>(model.pairs.size()), model.surfaces.surfaces.size()) {}

/// Whether a node lies right behind one of the faces of its element that it may go out of, by a share of the
/// thickness of the thinner side at most.
bool DeepOverlaps::is_shallow(const ContactKinematics& kinematics, const Inside& inside, double share,
                              std::span<const FaceIndex> faces) const {
  const OverlapNode& own = parts_.of_node[inside.row];
  const Eigen::Vector3d point = kinematics.x(contact_mesh().surface_nodes[inside.row].node);
  return std::ranges::any_of(faces, [&](FaceIndex index) {
    const auto closest =
        project_onto_face(kinematics.face_corners(index), contact_mesh().faces[index].is_triangle(), point);
    if (!closest || closest->edge || own.normal.dot(closest->normal) > same_way_cosine * own.normal.norm())
      return false;
    const double other = parts_.of_face[index].half_thickness;
    const double half_thickness = own.half_thickness > 0.0 ? std::min(own.half_thickness, other) : other;
    return -closest->gap <= share * 2.0 * half_thickness;
  });
}

/// The rows that the box of another body may hold, ascending: of most bodies none does. Nothing where the
/// place of one is no number.
///   boxes   of thick bodies
///   around  the same, searched
std::optional<std::vector<SurfaceNodeIndex>> DeepOverlaps::find_rows_near_others(
    const ContactKinematics& kinematics, std::span<const Box> boxes, BroadPhase& around) const {
  // Around the thick bodies that each thick body meets, and around all of them: what is of no thick body, and
  // points of lofts, may stand outside the box of their own.
  std::vector<Box> met(boxes.size(), empty_box());
  Box all = empty_box();
  for (const Box& box : boxes) add_box(box, all);
  PairTable meeting;
  around.find_pairs([](std::uint32_t, std::uint32_t) { return true; }, meeting);
  for (std::uint32_t body = 0; body < boxes.size(); ++body) {
    for (const std::uint32_t other : meeting.of(body)) {
      add_box(boxes[other], met[body]);
      add_box(boxes[body], met[other]);
    }
  }
  std::vector<SurfaceNodeIndex> rows;
  for (const SurfaceNodeIndex row : indices(contact_mesh().surface_nodes)) {
    const ContactNodeIndex node = contact_mesh().surface_nodes[row].node;
    const auto x = kinematics.x(node);
    if (!x.allFinite()) return std::nullopt;
    const auto body = volumes_.number_of_body(contact_mesh().mesh_nodes[node].value);
    if (is_near(body && contact_mesh().is_mesh_point(node) ? met[*body] : all, x)) rows.push_back(row);
  }
  return rows;
}

std::vector<DeepOverlaps::Inside> DeepOverlaps::find_inside(const Eigen::Matrix3Xd& coordinates,
                                                            const ContactKinematics& kinematics,
                                                            double shallow) const {
  const std::vector<std::uint32_t>& thick_bodies = volumes_.thick_bodies();
  if (contact_mesh().surface_nodes.empty() || thick_bodies.empty()) return {};
  const auto place_of = [&](SurfaceNodeIndex row) {
    return kinematics.x(contact_mesh().surface_nodes[row].node);
  };
  BroadPhase rows, around, inner;
  const std::vector<Box> around_bodies = volumes_.boxes(coordinates, kinematics);
  if (around.update(around_bodies)) return {};
  const auto wanted = find_rows_near_others(kinematics, around_bodies, around);
  if (!wanted || wanted->empty()) return {};
  const auto box_of_row = [&](std::uint32_t i) {
    Box box = empty_box();
    add_point(place_of((*wanted)[i]), box);
    return box;
  };
  const auto n_rows = static_cast<std::uint32_t>(wanted->size());
  if (rows.update(n_rows, box_of_row)) return {};
  PairTable near;
  rows.find_pairs(
      around,
      [&](std::uint32_t i, std::uint32_t body) { return body_of_row((*wanted)[i]) != thick_bodies[body]; },
      near);
  std::vector<Box> boxes(thick_bodies.size(), empty_box());
  for (std::uint32_t i = 0; i < n_rows; ++i) {
    for (const std::uint32_t body : near.of(i)) add_point(place_of((*wanted)[i]), boxes[body]);
  }
  const std::vector<BodyVolume> volumes = volumes_.near(coordinates, kinematics, boxes);
  if (volumes.empty()) return {};
  const auto box_of_volume = [&](std::uint32_t i) {
    Box box = empty_box();
    for (Eigen::Index k = 0; k < topology(volumes[i].shape).n_corners; ++k)
      add_point(volumes[i].corners.col(k), box);
    return box;
  };
  if (inner.update(static_cast<std::uint32_t>(volumes.size()), box_of_volume)) return {};
  const auto is_inside = [&](std::uint32_t row, std::uint32_t i) {
    const BodyVolume& volume = volumes[i];
    if (volume.body == body_of_row((*wanted)[row])) return false;
    return is_in_solid(volume.corners, topology(volume.shape), place_of((*wanted)[row]));
  };
  rows.find_pairs(inner, is_inside, near);
  std::vector<Inside> inside;
  for (std::uint32_t k = 0; k < n_rows; ++k) {
    const SurfaceNodeIndex row = (*wanted)[k];
    for (const std::uint32_t i : near.of(k)) {
      const std::uint32_t body = *volumes_.number_of_body(volumes[i].body);
      const bool is_known = !inside.empty() && inside.back().row == row && inside.back().body == body;
      if (!is_known) inside.push_back({row, body, volumes[i].element});
    }
  }
  if (shallow > 0.0) leave_out_shallow(kinematics, shallow, inside);
  return inside;
}

/// Leaves out what is_shallow() in the element that it lies in.
void DeepOverlaps::leave_out_shallow(const ContactKinematics& kinematics, double share,
                                     std::vector<Inside>& inside) const {
  if (inside.empty()) return;
  std::vector<std::pair<ElementIndex, FaceIndex>> of_element;
  for (const FaceIndex i : indices(contact_mesh().faces))
    of_element.emplace_back(contact_mesh().faces[i].side.element(), i);
  std::ranges::sort(of_element);
  std::vector<FaceIndex> faces;
  std::erase_if(inside, [&](const Inside& one) {
    faces.clear();
    for (const auto& [element, face] :
         std::ranges::equal_range(of_element, one.element, {}, &std::pair<ElementIndex, FaceIndex>::first))
      faces.push_back(face);
    return is_shallow(kinematics, one, share, faces);
  });
}

/// Whether one of a node's own faces is facing a face; what has none is facing all.
bool DeepOverlaps::is_facing(const ContactKinematics& kinematics, const SurfaceNode& node,
                             const Eigen::Vector3d& normal) const {
  if (node.radius > 0.0f) return true;
  const auto own_faces = contact_mesh().faces_of_node.of(node.node);
  return own_faces.empty() || std::ranges::any_of(own_faces, [&](FaceIndex index) {
           const ContactFace& face = contact_mesh().faces[index];
           const Eigen::Vector3d area = kinematics.area(face);
           return face.surface == node.surface && area.dot(normal) < facing_cosine * area.norm();
         });
}

std::optional<DeepOverlap> DeepOverlaps::find_way_out(
    const ContactKinematics& kinematics, const Inside& inside,
    const PairLists<std::uint32_t, FaceIndex>& faces_of_body) const {
  const SurfaceNode& node = contact_mesh().surface_nodes[inside.row];
  const Eigen::Vector3d point = kinematics.x(node.node);
  const OverlapNode& own = parts_.of_node[inside.row];
  // A sheet or a sphere may go out either way.
  const bool has_normal = !parts_.is_lofted(node) && own.normal.norm() > smallest_share * own.size * own.size;
  std::optional<DeepOverlap> best;
  double least = std::numeric_limits<double>::infinity();
  for (const FaceIndex index : faces_of_body.of(inside.body)) {
    const ContactFace& face = contact_mesh().faces[index];
    const OptionalIndex<PairIndex> pair = rules_.find(node.surface, face.surface);
    if (!pair || !takes_part(*rules_[*pair].pair, face, contact_mesh(), mesh_)) continue;
    const bool is_lofted = contact_mesh().is_lofted(face);
    if (is_lofted && rules_[*pair].law == ContactLaw::tied) continue;
    FaceCorners x;
    for (std::size_t k = 0; k < 4; ++k) x.col(static_cast<Eigen::Index>(k)) = kinematics.x(face.corners[k]);
    const Eigen::Vector3d middle = 0.5 * (x.col(0) + x.col(2));
    if ((point - middle).norm() - (x.colwise() - middle).colwise().norm().maxCoeff() > least) continue;
    const SmoothFace* round = contact_mesh().smooth_faces.find(rules_[*pair].pair->smoothing, index);
    const auto closest = project_sphere(x, face.is_triangle(), round, point, 0.0);
    if (!closest) continue;
    const double cosine = has_normal ? own.normal.dot(closest->normal) / own.normal.norm() : -1.0;
    if (cosine > same_way_cosine || (is_lofted && !is_facing(kinematics, node, closest->normal))) continue;
    if (std::hypot(closest->gap, closest->beyond) <= smallest_share * parts_.of_face[index].size)
      return std::nullopt;
    // Behind a facet, and still before the round surface that it stands for.
    if (round != nullptr && !closest->edge && closest->gap > 0.0 && closest->gap <= round->height())
      return std::nullopt;
    if (closest->gap > 0.0) continue;
    const double cost = std::hypot(closest->gap, closest->beyond) * (1.0 + 2.0 * (1.0 + cosine));
    if (cost >= least) continue;
    least = cost;
    const double depth = static_cast<double>(node.radius) - closest->gap;
    best = DeepOverlap{*pair, inside.row, index, depth, closest->normal, false};
  }
  if (!best || !(best->depth > smallest_share * parts_.of_face[best->face].size)) return std::nullopt;
  const double own_half_thickness =
      own.half_thickness > 0.0 ? own.half_thickness : std::numeric_limits<double>::infinity();
  // One side of a shell alone is met through all of its thickness.
  const double reach = rules_[best->pair].pair->is_polar() ? 2.0 : 1.0;
  const double half_thickness =
      reach * std::min(own_half_thickness, parts_.of_face[best->face].half_thickness);
  const bool is_lofted = contact_mesh().is_lofted(contact_mesh().faces[best->face]);
  best->is_deep = best->depth > (is_lofted ? 1.0 + smallest_share : 1.0) * half_thickness;
  if (is_lofted && !best->is_deep) return std::nullopt;
  return best;
}

std::vector<DeepOverlap> DeepOverlaps::find(const Eigen::Matrix3Xd& coordinates,
                                            const ContactKinematics& kinematics, double shallow) const {
  const std::vector<Inside> inside = find_inside(coordinates, kinematics, shallow);
  if (inside.empty()) return {};
  const auto faces_of_body =
      list_by_row<std::uint32_t, FaceIndex>(volumes_.thick_bodies().size(), [&](const auto& take) {
        for (const FaceIndex i : indices(contact_mesh().faces)) {
          const std::uint32_t node = contact_mesh().mesh_nodes[contact_mesh().faces[i].corners[0]].value;
          if (const auto number = volumes_.number_of_body(node)) take(*number, i);
        }
      });
  std::vector<std::optional<DeepOverlap>> ways(inside.size());
#pragma omp parallel for schedule(dynamic, 16) num_threads(threads_for(inside.size() * 100))
  for (std::size_t i = 0; i < inside.size(); ++i)
    ways[i] = find_way_out(kinematics, inside[i], faces_of_body);
  // Top and bottom of a sheet face opposite faces of a loft: their node goes the shorter way.
  const auto is_of_loft = [&](const std::optional<DeepOverlap>& way) {
    return way && contact_mesh().is_lofted(contact_mesh().faces[way->face]);
  };
  std::map<std::pair<NodeIndex, std::uint32_t>, double> least;
  const auto key = [&](std::size_t i) {
    return std::pair(contact_mesh().mesh_nodes[contact_mesh().surface_nodes[inside[i].row].node],
                     inside[i].body);
  };
  for (std::size_t i = 0; i < ways.size(); ++i) {
    if (!is_of_loft(ways[i])) continue;
    const auto [known, is_new] = least.try_emplace(key(i), ways[i]->depth);
    known->second = std::min(known->second, ways[i]->depth);
  }
  std::vector<DeepOverlap> found;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const bool is_longer = is_of_loft(ways[i]) && ways[i]->depth > least[key(i)];
    if (ways[i] && !is_longer) found.push_back(*ways[i]);
  }
  return found;
}

}  // namespace contactsim

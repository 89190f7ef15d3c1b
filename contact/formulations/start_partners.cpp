// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/start_partners.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "contact/formulations/face_plane.hpp"
#include "contact/formulations/interface_constraint.hpp"
#include "contact/formulations/near_pairs.hpp"
#include "contact/geometry/node_face.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

/// Faces whose normals have a greater cosine are of one wall, and a node keeps the nearest of a wall.
constexpr double one_wall = 0.9;

/// A face that is farther by this share of its size is behind another one.
constexpr double farther_share = 1e-3;

/// Overlaps of less than this share of the smaller face are none.
constexpr double negligible_overlap = 1e-6;

/// The side of each pair that slides.
class SlidingSides {
 public:
  SlidingSides(const ContactKinematics& start, const PairRules& rules) : start_(start), rules_(rules) {
    const ContactMesh& contact_mesh = start.contact_mesh();
    area_.assign(contact_mesh.n_surfaces(), 0.0);
    for (const ContactFace& face : contact_mesh.faces) area_[face.surface] += start.area(face).norm();
  }

  /// The rule of two surfaces that slide infinitesimally; null otherwise.
  const PairRule* find(SurfaceIndex surface, SurfaceIndex other) const {
    const OptionalIndex<PairIndex> pair = rules_.find(surface, other);
    if (!pair || rules_[*pair].only_ties()) return nullptr;
    const bool is_small = rules_[*pair].pair->behavior == InteractionBehavior::infinitesimal_sliding;
    return is_small ? &rules_[*pair] : nullptr;
  }
  /// Whether a surface slides on another one.
  bool slides(const SurfacePair& pair, SurfaceIndex surface, SurfaceIndex other) const {
    if (surface == other) return true;
    if (pair.side_b && pair.formulation == ConstraintFormulation::node_face) return surface == *pair.side_b;
    return area_[surface] < area_[other] || (area_[surface] == area_[other] && surface > other);
  }
  /// Whether the first of two faces slides on the second.
  bool slides_first(const SurfacePair& pair, const ContactFace& first, const ContactFace& second) const {
    if (first.surface != second.surface) return slides(pair, first.surface, second.surface);
    return start_.area(first).norm() <= start_.area(second).norm();
  }

 private:
  const ContactKinematics& start_;
  const PairRules& rules_;
  IndexedVector<SurfaceIndex, double> area_;  // [length^2]
};

Eigen::Vector3d centre_of(const MovingFace& face) { return face.x.rowwise().mean(); }

/// Whether two faces lie over each other, neither behind the material of the other.
bool lie_over(const ContactKinematics& start, FaceIndex first, FaceIndex second) {
  const auto found = find_face_face_points(start.face(first), start.face(second));
  if (!found) return false;
  const ContactFace &a = start.contact_mesh().faces[first], &b = start.contact_mesh().faces[second];
  const double smaller = std::min(start.area(a).norm(), start.area(b).norm());
  if (!(found->points.area > negligible_overlap * smaller)) return false;
  double nearest = -std::numeric_limits<double>::infinity();
  for (const OverlapBatch& batch : found->points.batches())
    nearest = std::max(nearest, (batch.weight > 0.0).select(batch.gap, nearest).maxCoeff());
  return -nearest <= std::min(a.penalty_properties.thickness, b.penalty_properties.thickness);
}

/// A face that a node projects inside.
struct Over {
  FaceIndex face;
  Eigen::Vector3d normal;
  double distance = 0.0, size = 0.0;
};

std::optional<Over> find_over(const ContactKinematics& start, const SurfacePair& pair, SurfaceNodeIndex row,
                              FaceIndex index) {
  const SurfaceNode& node = start.contact_mesh().surface_nodes[row];
  const MovingFace face = start.face(index);
  const auto point = project_onto_face(face.x, face.is_triangle, start.x(node.node));
  const double size = start.bound(index).radius();
  if (!point || point->beyond > pair.tangential_tolerance.value_or(automatic_beyond * size))
    return std::nullopt;
  const double thickness = start.contact_mesh().faces[index].penalty_properties.thickness;
  if (point->gap - node.radius < -thickness || !is_facing(start, node, point->normal)) return std::nullopt;
  return Over{index, point->normal, std::abs(point->gap), size};
}

/// The faces that others lie over on which they slide infinitesimally.
FacePairLists find_over(const SlidingSides& sides, const ContactKinematics& start,
                        const FacePairLists& candidates) {
  const auto& faces = start.contact_mesh().faces;
  const auto visit = [&](const auto& take) {
    for (const FaceIndex first : candidates.rows()) {
      for (const FaceIndex second : candidates.of(first)) {
        if (sides.find(faces[first].surface, faces[second].surface) != nullptr &&
            lie_over(start, first, second))
          take(first, second);
      }
    }
  };
  return list_by_row<FaceIndex, FaceIndex>(candidates.n_rows(), visit);
}

/// The faces that nodes project inside on which they slide infinitesimally: of each wall the nearest.
NodeFaceLists find_over(const SlidingSides& sides, const ContactKinematics& start,
                        const NodeFaceLists& candidates) {
  const ContactMesh& contact_mesh = start.contact_mesh();
  IndexedVector<SurfaceNodeIndex, std::vector<FaceIndex>> kept(candidates.n_rows());
  for (const SurfaceNodeIndex row : candidates.rows()) {
    const SurfaceIndex surface = contact_mesh.surface_nodes[row].surface;
    std::vector<Over> over;
    for (const FaceIndex face : candidates.of(row)) {
      const SurfaceIndex other = contact_mesh.faces[face].surface;
      const PairRule* rule = sides.find(surface, other);
      if (rule == nullptr || !sides.slides(*rule->pair, surface, other)) continue;
      if (const auto found = find_over(start, *rule->pair, row, face)) over.push_back(*found);
    }
    for (const Over& one : over) {
      const bool is_behind = std::ranges::any_of(over, [&](const Over& other) {
        return one.normal.dot(other.normal) > one_wall &&
               one.distance > other.distance + farther_share * one.size;
      });
      if (!is_behind) kept[row].push_back(one.face);
    }
  }
  return list_by_row<SurfaceNodeIndex, FaceIndex>(candidates.n_rows(), [&](const auto& take) {
    for (const SurfaceNodeIndex row : indices(kept)) {
      for (const FaceIndex face : kept[row]) take(row, face);
    }
  });
}

}  // namespace

template <class Row>
void StartPartners<Row>::begin_faces(const ContactKinematics& start, const PairRules& rules,
                                     const Lists& candidates) requires std::same_as<Row, FaceIndex> {
  const SlidingSides sides(start, rules);
  const auto& faces = start.contact_mesh().faces;
  lists_ = find_over(sides, start, candidates);
  for (const FaceIndex first : lists_.rows()) {
    for (const FaceIndex second : lists_.of(first)) {
      const PairRule& rule = *sides.find(faces[first].surface, faces[second].surface);
      const bool slides_first = sides.slides_first(*rule.pair, faces[first], faces[second]);
      const MovingFace a = start.face(first), b = start.face(second);
      const MovingFace &slides = slides_first ? a : b, &still = slides_first ? b : a;
      starts_.push_back({axes_of(still.x).transpose() * (centre_of(slides) - centre_of(still)), slides_first,
                         *rules.find(faces[first].surface, faces[second].surface)});
    }
  }
}

template <class Row>
void StartPartners<Row>::begin_nodes(const ContactKinematics& start, const PairRules& rules,
                                     const Lists& candidates) requires std::same_as<Row, SurfaceNodeIndex> {
  const SlidingSides sides(start, rules);
  const ContactMesh& contact_mesh = start.contact_mesh();
  lists_ = find_over(sides, start, candidates);
  for (const SurfaceNodeIndex row : lists_.rows()) {
    for (const FaceIndex face : lists_.of(row))
      starts_.push_back(
          {Eigen::Vector3d::Zero(), true,
           *rules.find(contact_mesh.surface_nodes[row].surface, contact_mesh.faces[face].surface)});
  }
}

template <class Row>
typename StartPartners<Row>::Lists StartPartners<Row>::restricted(
    const PairRules& rules, const ContactMesh& contact_mesh,
    const Lists& candidates) const requires std::same_as<Row, FaceIndex> {
  // By surface: a face may project onto one surface and be free against others.
  std::map<std::pair<FaceIndex, PairIndex>, bool> stands;  // by face and pair
  const auto pair_of = [&](FaceIndex a, FaceIndex b) {
    return *rules.find(contact_mesh.faces[a].surface, contact_mesh.faces[b].surface);
  };
  for (const FaceIndex row : lists_.rows()) {
    for (std::size_t k = lists_.first_pair(row); k < lists_.end_pair(row); ++k)
      stands[{sliding(k, row), pair_of(row, lists_.partner(k))}] = true;
  }
  return list_by_row<FaceIndex, FaceIndex>(candidates.n_rows(), [&](const auto& take) {
    for (const FaceIndex row : candidates.rows()) {
      for (const FaceIndex partner : candidates.of(row)) {
        const PairIndex pair = pair_of(row, partner);
        if (has(row, partner) || (!stands.contains({row, pair}) && !stands.contains({partner, pair})))
          take(row, partner);
      }
    }
  });
}

template <class Row>
typename StartPartners<Row>::Lists StartPartners<Row>::united_with(const PairRules& rules,
                                                                   const Lists& candidates) const {
  const auto keeps = [&](std::size_t k) {
    const SurfacePair& own = *rules[starts_[k].pair].pair;
    return rules.find(own.first, own.second) == starts_[k].pair;
  };
  return list_by_row<Row, FaceIndex>(candidates.n_rows(), [&](const auto& take) {
    for (const Row row : candidates.rows()) {
      const bool has_own = row.value < lists_.n_rows();
      std::size_t k = has_own ? lists_.first_pair(row) : 0;
      const std::size_t end = has_own ? lists_.end_pair(row) : 0;
      const auto take_own_before = [&](FaceIndex partner) {
        for (; k < end && lists_.partner(k) < partner; ++k) {
          if (keeps(k)) take(row, lists_.partner(k));
        }
      };
      for (const FaceIndex partner : candidates.of(row)) {
        take_own_before(partner);
        if (k < end && lists_.partner(k) == partner) ++k;
        take(row, partner);
      }
      take_own_before({std::numeric_limits<std::uint32_t>::max()});
    }
  });
}

template <class Row>
std::optional<std::size_t> StartPartners<Row>::find(Row row, FaceIndex partner) const {
  if (row.value >= lists_.n_rows()) return std::nullopt;
  const std::size_t k = lists_.position(row, partner);
  const bool is_there = k < lists_.end_pair(row) && lists_.partner(k) == partner;
  return is_there ? std::optional(k) : std::nullopt;
}

template <class Row>
std::optional<PartnerCarry> StartPartners<Row>::find_carry(
    const ContactKinematics& kinematics, FaceIndex first,
    FaceIndex second) const requires std::same_as<Row, FaceIndex> {
  const auto k = find(first, second);
  if (!k) return std::nullopt;
  const Start& start = starts_[*k];
  const MovingFace a = kinematics.face(first), b = kinematics.face(second);
  const MovingFace &slides = start.slides_first ? a : b, &still = start.slides_first ? b : a;
  const Eigen::Matrix3d axes = axes_of(still.x);
  Eigen::Vector3d slip = axes.transpose() * (centre_of(slides) - centre_of(still)) - start.apart;
  slip.z() = 0.0;
  return PartnerCarry{!start.slides_first, weights_of_way(still, axes * slip)};
}

template <class Row>
std::vector<ReleasedPartner<Row>> StartPartners<Row>::remap(const NewPositions<Row>& rows,
                                                            const NewPositions<FaceIndex>& faces,
                                                            std::size_t n_rows_after) {
  if (empty()) return {};
  std::map<std::pair<Row, PairIndex>, std::size_t> n_left;  // by what slides and pair, before
  for (const Row row : lists_.rows()) {
    for (std::size_t k = lists_.first_pair(row); k < lists_.end_pair(row); ++k)
      n_left[{sliding(k, row), starts_[k].pair}] += rows[row] && faces[lists_.partner(k)] ? 1 : 0;
  }
  std::vector<ReleasedPartner<Row>> released;
  for (const auto& [slides, n] : n_left) {
    if (n == 0 && rows[slides.first]) released.push_back({*rows[slides.first], slides.second});
  }
  std::vector<std::size_t> before;
  lists_ = transferred(lists_, rows, faces, n_rows_after, before);
  std::vector<Start> starts;
  for (const std::size_t old : before) starts.push_back(starts_[old]);
  starts_ = std::move(starts);
  return released;
}

template <class Row>
void StartPartners<Row>::archive(const std::string& name, StateArchive& saved) {
  // Most runs have none, and states of such runs nothing of them.
  if (saved.restores() ? !saved.has(name + "/begin") : empty()) return;
  contactsim::archive(name, lists_, saved);
  saved.rows(name + "/starts", starts_,
             [](Start& start, RowNumbers& row) { row(start.apart, start.slides_first, start.pair.value); });
}

template class StartPartners<FaceIndex>;
template class StartPartners<SurfaceNodeIndex>;

}  // namespace contactsim

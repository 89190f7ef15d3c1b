// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/face_face/face_face_history.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

bool are_of_one_pair(const ContactPoint& a, const ContactPoint& b) {
  return a.first_entity == b.first_entity && a.second_entity == b.second_entity;
}

/// Numbers of the corners of faces.
constexpr std::uint32_t n_corners = 4;
FaceCornerIndex corner_of(FaceIndex face, Eigen::Index corner) {
  return {n_corners * face.value + static_cast<std::uint32_t>(corner)};
}

FaceCornerIndex nearest_corner(FaceIndex face, const Eigen::Vector4d& weights) {
  Eigen::Index nearest = 0;
  weights.maxCoeff(&nearest);
  return corner_of(face, nearest);
}

}  // namespace

bool FaceFaceHistory::is_held(const ContactPoint& point) const {
  return held_before_.has(point.pair, nearest_corner(point.first_face(), point.first.weights)) ||
         held_before_.has(point.pair, nearest_corner(point.second_face(), point.second.weights));
}

/// Corners that are about as near count too, or a place between them would be lost as it slides.
void FaceFaceHistory::hold(const ContactPoint& point) {
  constexpr double about_as_near = 0.75;
  const auto add = [&](FaceIndex face, const Eigen::Vector4d& weights) {
    for (Eigen::Index k = 0; k < n_corners; ++k) {
      if (weights[k] >= about_as_near * weights.maxCoeff()) held_now_.add(point.pair, corner_of(face, k));
    }
  };
  add(point.first_face(), point.first.weights);
  add(point.second_face(), point.second.weights);
}

Eigen::Vector3d FaceFaceHistory::elastic_slip(std::size_t candidate) const {
  if (!has_friction_ || touched_before_[candidate] == 0) return Eigen::Vector3d::Zero();
  return elastic_slips_[candidate];
}

Eigen::Vector3d FaceFaceHistory::mean_slip(FaceIndex first, FaceIndex second) const {
  const Eigen::Vector4d &of_first = means_[first], &of_second = means_[second];
  if (of_first[3] > 0.0) return of_first.head<3>() / of_first[3];
  if (of_second[3] > 0.0) return -of_second.head<3>() / of_second[3];
  return Eigen::Vector3d::Zero();
}

double FaceFaceHistory::depth_before(FaceIndex first, FaceIndex second) const {
  if (depth_before_.empty()) return 0.0;
  return std::max(depth_before_[first], depth_before_[second]);
}

void FaceFaceHistory::transfer(const FacePairLists& before, const FacePairLists& after) {
  touched_now_ = transfer_pairs<std::uint8_t>(before, touched_now_, after, 0);
  if (has_friction_)
    elastic_slips_ = transfer_pairs<Eigen::Vector3d>(before, elastic_slips_, after, Eigen::Vector3d::Zero());
}

void FaceFaceHistory::remap(const ContactRemap& remap, std::span<const std::size_t> before) {
  const auto take_over = [&](auto& values) {
    auto taken = std::exchange(values, {});
    values.reserve(before.size());
    for (const std::size_t old : before) values.push_back(taken[old]);
  };
  take_over(touched_now_);
  if (has_friction_) take_over(elastic_slips_);
  const Eigen::Vector4d no_slip = Eigen::Vector4d::Zero();
  contactsim::transfer(remap.faces, remap.n_faces_after, no_slip, means_);
  contactsim::transfer(remap.faces, remap.n_faces_after, no_slip, next_means_);
  contactsim::transfer(remap.faces, remap.n_faces_after, 0.0f, depth_before_);
  contactsim::transfer(remap.faces, remap.n_faces_after, 0.0f, depth_now_);
  NewPositions<FaceCornerIndex> corners;
  for (const OptionalIndex<FaceIndex> face : remap.faces) {
    for (Eigen::Index k = 0; k < n_corners; ++k)
      corners.push_back(face ? OptionalIndex<FaceCornerIndex>(corner_of(*face, k)) : std::nullopt);
  }
  if (may_hold_) held_now_.remap(Unchanged{}, corners);
  // Contacts that deaths end are not lost.
  for (NewPositions<FaceIndex>* partners : {&partner_before_, &partner_now_})
    partners->assign(depth_now_.size(), std::nullopt);
}

void FaceFaceHistory::swap_steps() {
  std::swap(touched_before_, touched_now_);
  std::swap(held_before_, held_now_);
  std::swap(depth_before_, depth_now_);
  std::swap(partner_before_, partner_now_);
  if (has_friction_) std::swap(means_, next_means_);
}

void FaceFaceHistory::begin_step(const FacePairLists& candidates, std::size_t n_faces) {
  swap_steps();
  touched_now_.assign(candidates.partners.size(), 0);
  held_now_.clear();
  depth_before_.resize(n_faces, 0.0f);
  partner_before_.resize(n_faces);
  depth_now_.assign(n_faces, 0.0f);
  partner_now_.assign(n_faces, std::nullopt);
  if (!has_friction_) return;
  means_.resize(n_faces, Eigen::Vector4d::Zero());
  next_means_.assign(n_faces, Eigen::Vector4d::Zero());
}

void FaceFaceHistory::update(const ContactStepContext& context, const FacePairLists& candidates,
                             std::span<const ContactPoint> points) {
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    const ContactPoint& first = points[begin];
    while (end < points.size() && are_of_one_pair(first, points[end])) ++end;
    const std::size_t candidate = candidates.position(first.first_face(), first.second_face());
    update_pair(context, candidate, points.subspan(begin, end - begin));
  }
  for (const ContactPoint& point : points) update_faces(point);
}

/// Facets of one face share the slip that is held: the mean by area. A junction's spring is its own: what
/// only touches has none.
void FaceFaceHistory::update_pair(const ContactStepContext& context, std::size_t candidate,
                                  std::span<const ContactPoint> points) {
  const PairRule& rule =
      context.rules.of_faces(points[0].pair, points[0].first_face(), points[0].second_face());
  const bool has_junction = rule.acts_apart() && rule.interface_law->rate_limit;
  if (has_junction) elastic_slips_[candidate].setZero();
  double area = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const ContactPoint& point : points) {
    if (point.is_held_apart) {
      touched_now_[candidate] |= held_apart;
      if (has_junction) elastic_slips_[candidate] = point.elastic_slip;
      continue;
    }
    if (!point.is_met()) continue;
    touched_now_[candidate] |= touched;
    if (!rule.pair->separates) hold(point);
    if (point.is_balanced) continue;
    area += point.area;
    mean += point.area / area * (point.elastic_slip - mean);
  }
  if (area > 0.0 && rule.friction > 0.0) elastic_slips_[candidate] = mean;
}

void FaceFaceHistory::update_faces(const ContactPoint& point) {
  if (!point.is_met() || point.is_held_apart) return;
  const auto deepen = [&](FaceIndex face, FaceIndex partner) {
    const float depth = std::max(static_cast<float>(-point.gap), std::numeric_limits<float>::min());
    if (!(depth > depth_now_[face])) return;
    depth_now_[face] = depth;
    partner_now_[face] = partner;
  };
  deepen(point.first_face(), point.second_face());
  deepen(point.second_face(), point.first_face());
  if (!has_friction_ || point.is_balanced) return;
  Eigen::Vector4d share;
  share << point.area * point.elastic_slip, 0.0;
  const Eigen::Vector4d area(0.0, 0.0, 0.0, point.area);
  next_means_[point.first_face()] += share + area;
  next_means_[point.second_face()] += area - share;
}

void FaceFaceHistory::find_lost(const ContactMesh& contact_mesh, const PairRules& rules,
                                std::vector<LostContact>& lost) const {
  for (const FaceIndex face : indices(partner_before_)) {
    if (!partner_before_[face] || *partner_before_[face] < face) continue;
    const FaceIndex partner = *partner_before_[face];
    if (partner_now_[face] || partner_now_[partner]) continue;
    const ContactFace &a = contact_mesh.faces[face], &b = contact_mesh.faces[partner];
    const double depth = depth_before_[face];
    if (depth < deep_share * std::min(a.penalty_properties.thickness, b.penalty_properties.thickness))
      continue;
    lost.push_back({*rules.find(a.surface, b.surface), a.corners[0], depth});
  }
}

void FaceFaceHistory::archive(StateArchive& saved) {
  saved.list("contact/face_pairs/touched", touched_now_);
  saved.list("contact/face_pairs/elastic_slip", elastic_slips_);
  // What is known of faces between steps; begin_step() makes it that of the last one.
  saved.list("contact/faces/mean_slip", next_means_);
  saved.list("contact/faces/depth", depth_now_);
  saved.list("contact/faces/partner", partner_now_);
  if (may_hold_) held_now_.archive("contact/faces/held", saved);
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/face_face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "contact/geometry/facets.hpp"
#include "contact/geometry/overlap_polygons.hpp"
#include "core/interface_laws/pressure_law.hpp"

namespace contactsim {

namespace {

/// The penalties of eight pairs.
struct Penalties {
  Lanes stiffness = 0.0, damping = 0.0;  // see PairPenalty
  DepthLaws law;
  bool are_damped = false, have_pressures = false;  // any

  explicit Penalties(std::span<const PushedFaces> pairs) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto lane = static_cast<Eigen::Index>(i);
      const PairPenalty& penalty = pairs[i].penalty;
      stiffness(lane) = penalty.stiffness;
      damping(lane) = penalty.damping;
      law.set(lane, penalty.law);
      are_damped = are_damped || penalty.damping > 0.0;
      have_pressures = have_pressures || penalty.pressure != nullptr;
    }
  }
};

/// What of pairs touches and what may soon touch. What lies deeper than the depth is another wall, as is what
/// lies behind it.
struct PenaltyOverlaps {
  ///   is_near   elsewhere there is none
  ///   is_uncut  all of the overlap is near, and on one side of where the gap closes
  PenaltyOverlaps(const ProjectedPairs& pairs, const Lanes& activation_distance, const Lanes& depth,
                  const LaneMask& is_near, const LaneMask& is_uncut)
      : polygons(pairs, is_near), near_area(polygons.area()), touch(is_uncut && pairs.max_gap <= 0.0) {
    const LaneMask is_cut = is_near && !is_uncut && near_area > 0.0;
    if (!is_cut.any()) return;
    polygons.set_gaps(pairs);
    const OverlapPolygons near = polygons.part_between(-depth, activation_distance),
                          behind = near.part_between(-depth, 0.0);
    near_area = is_cut.select(near.area(), near_area);
    const LaneMask is_behind = is_cut && behind.area() > 0.0;
    touch = touch || is_behind;
    polygons.set_where(is_cut, near);
    polygons.set_where(is_behind, behind);
  }

  OverlapPolygons polygons;  // of what touches, else of what may soon
  Lanes near_area;           // of both, in the planes [length^2]
  LaneMask touch;
};

/// Sums over the points of overlaps.
class PressureSums {
 public:
  PressureSums(const ProjectedPairs& pairs, std::span<const PushedFaces> faces,
               const PenaltyOverlaps& overlaps)
      : pairs_(pairs), faces_(faces), penalties_(faces), touch_(overlaps.touch) {
    if (penalties_.are_damped) {
      speed_1_ = make_functions(pairs.speeds_1, pairs.are_triangles_1);
      speed_2_ = make_functions(pairs.speeds_2, pairs.are_triangles_2);
    }
    overlaps.polygons.visit_points(
        [&](const Lanes& u, const Lanes& v, const Lanes& area) { add(u, v, area * pairs.planes.spread); });
  }

  ///   near_area  of the pair [length^2]
  FaceFaceContact contact(std::size_t pair, double near_area) const {
    const auto lane = static_cast<Eigen::Index>(pair);
    const PushedFaces& faces = faces_[pair];
    FaceFaceContact contact;
    if (!(areas_1_[0](lane) > 0.0)) return contact;
    contact.gap = gap_(lane);
    contact.stiffness = faces.penalty.slope(faces.penalty.closing - contact.gap) * near_area;
    const double force = forces_1_[0](lane);
    if (force > 0.0) {
      contact.deepest = -contact.gap;
      contact.force = force;
      contact.gap = -work_(lane) / force;
    }
    contact.overlaps = contact.gap < faces.activation_distance && -contact.gap <= faces.penalty.depth;
    if (!contact.overlaps) return contact;
    contact.area = area_(lane);
    contact.beyond_spring = beyond_spring_(lane);
    contact.damped_power = damped_power_(lane);
    contact.normal = vector_in(pairs_.planes.normal, lane);
    // Corner shares of the force, of the area when there is none.
    const bool has_force = force > 0.0;
    contact.weights_1 = shares(has_force ? forces_1_ : areas_1_, faces.first.is_triangle, lane);
    contact.weights_2 = shares(has_force ? forces_2_ : areas_2_, faces.second.is_triangle, lane);
    return contact;
  }

 private:
  static Eigen::Vector4d shares(const MomentsOfFaces& moments, bool is_triangle, Eigen::Index lane) {
    return corner_shares(moments_in(moments, lane), is_triangle) / moments[0](lane);
  }

  void add(const Lanes& u, const Lanes& v, const Lanes& area) {
    const OverlapBatch at = locate_on_both(pairs_.maps_1, pairs_.maps_2, u, v);
    gap_ = gap_.min((area > 0.0).select(at.gap, gap_));
    add_moments(area, at.xi_1, at.eta_1, areas_1_);
    add_moments(area, at.xi_2, at.eta_2, areas_2_);
    if (!touch_.any()) return;
    const Lanes touching = touch_.select(area, 0.0), depth = (-at.gap).max(0.0);
    const Lanes spring_depth = penalties_.law.spring_depth(depth),
                stiffness = penalties_.stiffness * touching;
    Lanes force = stiffness * spring_depth,
          beyond = stiffness * (penalties_.law.potential(depth) - 0.5 * spring_depth * depth);
    if (penalties_.have_pressures) take_pressures(touching, depth, force, beyond);
    beyond_spring_ += beyond;
    if (penalties_.are_damped) force += add_damping(at, touching, force);
    area_ += touching;
    work_ += force * depth;
    add_moments(force, at.xi_1, at.eta_1, forces_1_);
    add_moments(force, at.xi_2, at.eta_2, forces_2_);
  }

  void take_pressures(const Lanes& area, const Lanes& depth, Lanes& force, Lanes& beyond) const {
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const auto lane = static_cast<Eigen::Index>(i);
      const PressureLaw* const pressure = faces_[i].penalty.pressure;
      if (pressure == nullptr) continue;
      force(lane) = area(lane) > 0.0 ? area(lane) * pressure->at(depth(lane)) : 0.0;
      beyond(lane) = area(lane) > 0.0
                         ? area(lane) * pressure->potential(depth(lane)) - 0.5 * force(lane) * depth(lane)
                         : 0.0;
    }
  }

  /// Damping never pulls: what it takes from a separating point ends with the spring's force.
  Lanes add_damping(const OverlapBatch& at, const Lanes& area, const Lanes& spring) {
    const Lanes speed = evaluate(speed_1_, at.xi_1, at.eta_1) - evaluate(speed_2_, at.xi_2, at.eta_2);
    Lanes undamped = -penalties_.damping * area * speed;
    for (std::size_t i = 0; penalties_.have_pressures && i < faces_.size(); ++i) {
      const auto lane = static_cast<Eigen::Index>(i);
      if (faces_[i].penalty.pressure != nullptr)
        undamped(lane) *= faces_[i].penalty.damping_factor(-at.gap(lane));
    }
    const Lanes damping = (penalties_.damping > 0.0).select(undamped.max(-spring), 0.0);
    damped_power_ -= damping * speed;
    return damping;
  }

  const ProjectedPairs& pairs_;
  std::span<const PushedFaces> faces_;
  Penalties penalties_;
  LaneMask touch_;
  FunctionsOfFaces speed_1_, speed_2_;
  MomentsOfFaces areas_1_{}, areas_2_{}, forces_1_{}, forces_2_{};
  Lanes gap_ = std::numeric_limits<double>::infinity(), area_ = 0.0, work_ = 0.0, beyond_spring_ = 0.0,
        damped_power_ = 0.0;
};

}  // namespace

double PairPenalty::slope_of_pressure(double depth_ahead) const {
  return std::max(pressure->slope(depth_ahead), least_slope);
}

double PairPenalty::pressure_at(double at_depth) const {
  return pressure == nullptr ? stiffness * law.spring_depth(at_depth) : pressure->at(at_depth);
}

double PairPenalty::damping_factor(double at_depth) const {
  return pressure == nullptr ? 1.0 : std::sqrt(pressure->slope(at_depth) / stiffness);
}

namespace {

/// Appends the contacts of the facets of a pair.
void add_contacts_of_facets(const PushedFaces& faces, std::size_t number, bool is_split_1, bool is_split_2,
                            std::vector<PushedContact>& contacts) {
  const Facets facets_1(faces.first, is_split_1), facets_2(faces.second, is_split_2);
  std::vector<PushedFaces> pairs;
  std::vector<PushedContact> found;
  for (const Facet& a : facets_1.all()) {
    pairs.clear();
    found.clear();
    for (const Facet& b : facets_2.all())
      pairs.push_back({a.face, b.face, faces.penalty, faces.activation_distance, never_split});
    find_face_face_contacts(pairs, found);
    for (PushedContact& of_facets : found) {
      FaceFaceContact& contact = of_facets.contact;
      contact.weights_1 = a.to_face(contact.weights_1);
      contact.weights_2 = facets_2.all()[of_facets.pair].to_face(contact.weights_2);
      contacts.push_back({number, contact});
    }
  }
}

}  // namespace

void find_face_face_contacts(std::span<const PushedFaces> pairs, std::vector<PushedContact>& contacts) {
  const bool are_damped =
      std::ranges::any_of(pairs, [](const PushedFaces& faces) { return faces.penalty.damping > 0.0; });
  const ProjectedPairs projected = project_pairs(pairs, 0.0, are_damped);
  Lanes activation_distance = 0.0, depth = 0.0, flat = never_split;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto lane = static_cast<Eigen::Index>(i);
    activation_distance(lane) = pairs[i].activation_distance;
    depth(lane) = pairs[i].penalty.depth;
    flat(lane) = pairs[i].flat;
  }
  const LaneMask is_uncut = projected.planes.exist && projected.min_gap >= -depth &&
                            projected.max_gap <= activation_distance &&
                            (projected.max_gap <= 0.0 || projected.min_gap > 0.0);
  const LaneMask is_warped_1 = !is_uncut && projected.are_warped_1(flat),
                 is_warped_2 = !is_uncut && projected.are_warped_2(flat);
  const LaneMask is_split = is_warped_1 || is_warped_2;
  const LaneMask is_near =
      first_lanes(pairs.size()) && !is_split && projected.are_near(activation_distance, depth);
  std::optional<PenaltyOverlaps> overlaps;
  std::optional<PressureSums> sums;
  if (is_near.any()) {
    overlaps.emplace(projected, activation_distance, depth, is_near, is_uncut);
    sums.emplace(projected, pairs, *overlaps);
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto lane = static_cast<Eigen::Index>(i);
    if (is_split(lane)) add_contacts_of_facets(pairs[i], i, is_warped_1(lane), is_warped_2(lane), contacts);
    if (!is_near(lane) || !(overlaps->near_area(lane) > 0.0)) continue;
    const FaceFaceContact contact =
        sums->contact(i, overlaps->near_area(lane) * projected.planes.spread(lane));
    if (contact.overlaps) contacts.push_back({i, contact});
  }
}

FaceFaceContact find_face_face_contact(const MovingFace& first, const MovingFace& second,
                                       const PairPenalty& penalty, double activation_distance) {
  const PushedFaces faces{first, second, penalty, activation_distance, never_split};
  std::vector<PushedContact> found;
  find_face_face_contacts({&faces, 1}, found);
  return found.empty() ? FaceFaceContact{} : found[0].contact;
}

std::optional<FaceFacePoints> find_face_face_points(const MovingFace& first, const MovingFace& second) {
  const auto overlap = find_whole_overlap(first, second);
  if (!overlap) return std::nullopt;
  FaceFacePoints found{overlap->pair.planes.of(0), {}, first.is_triangle, second.is_triangle};
  overlap->polygon.visit_points([&](const Lanes& u, const Lanes& v, const Lanes& area) {
    found.points.add(locate_on_both(overlap->pair.maps_1, overlap->pair.maps_2, u, v), area(0));
  });
  return found;
}

}  // namespace contactsim

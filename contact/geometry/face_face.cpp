// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/face_face.hpp"

#include <algorithm>
#include <cmath>

#include "contact/geometry/projected_pair.hpp"
#include "core/interface_laws/pressure_law.hpp"

namespace contactsim {

namespace {

/// The component of a face's velocity along the normal, as a function on the face.
FaceFunction normal_speed(const MovingFace& face, const Eigen::Vector3d& normal) {
  const FaceMap map = make_face_map(face.v, face.is_triangle);
  return {map.c[0].dot(normal), map.c[1].dot(normal), map.c[2].dot(normal), map.c[3].dot(normal)};
}

/// What touches and what may soon touch of two faces.
struct Overlap {
  OverlapPoints points;
  double near_area = 0.0;  ///< [length^2]
  bool touches = false;    ///< points are of the part where the gap has closed
};

/// Sums over the points of an overlap.
class PressureSums {
 public:
  PressureSums(const Overlap& overlap, const PairPenalty& penalty)
      : points_(overlap.points), penalty_(penalty), touches_(overlap.touches) {}

  void set_damping(const MovingFace& first, const MovingFace& second, const Eigen::Vector3d& normal) {
    speed_1_ = normal_speed(first, normal);
    speed_2_ = normal_speed(second, normal);
  }

  void add(FaceFaceContact& contact) {
    contact.gap = std::numeric_limits<double>::infinity();
    for (const OverlapBatch& batch : points_.batches()) add(batch, contact);
    contact.stiffness = penalty_.slope(penalty_.closing - contact.gap);
    const double n = forces_1_[0];
    if (n > 0.0) {
      contact.deepest = -contact.gap;
      contact.force = n;
      contact.gap = -work_ / n;
    }
  }

  /// Corner shares of the force, of the area when there is none.
  Eigen::Vector4d weights(bool is_first, bool is_triangle) const {
    const FaceMoments& forces = is_first ? forces_1_ : forces_2_;
    if (forces[0] > 0.0) return corner_shares(forces, is_triangle) / forces[0];
    FaceMoments areas{};
    for (const OverlapBatch& batch : points_.batches()) {
      add_moments(batch.weight, is_first ? batch.xi_1 : batch.xi_2, is_first ? batch.eta_1 : batch.eta_2,
                  areas);
    }
    return corner_shares(areas, is_triangle) / areas[0];
  }

 private:
  void add(const OverlapBatch& batch, FaceFaceContact& contact) {
    contact.gap = std::min(contact.gap, (batch.weight > 0.0).select(batch.gap, contact.gap).minCoeff());
    if (!touches_) return;
    const Lanes depth = (-batch.gap).max(0.0);
    Lanes force = penalty_.pressure == nullptr ? spring_force(batch, depth, contact)
                                               : force_of_pressure(batch, depth, contact);
    if (penalty_.damping > 0.0) force += add_damping(batch, force, contact);
    contact.area += batch.weight.sum();
    work_ += (force * depth).sum();
    add_moments(force, batch.xi_1, batch.eta_1, forces_1_);
    add_moments(force, batch.xi_2, batch.eta_2, forces_2_);
  }

  Lanes spring_force(const OverlapBatch& batch, const Lanes& depth, FaceFaceContact& contact) const {
    const Lanes spring_depth = penalty_.law.spring_depth(depth),
                stiffness = penalty_.stiffness * batch.weight;
    contact.beyond_spring += (stiffness * (penalty_.law.potential(depth) - 0.5 * spring_depth * depth)).sum();
    return stiffness * spring_depth;
  }

  Lanes force_of_pressure(const OverlapBatch& batch, const Lanes& depth, FaceFaceContact& contact) const {
    Lanes force = Lanes::Zero();
    for (int lane = 0; lane < n_lanes; ++lane) {
      const double area = batch.weight(lane);
      if (!(area > 0.0)) continue;
      force(lane) = area * penalty_.pressure->at(depth(lane));
      contact.beyond_spring +=
          area * penalty_.pressure->potential(depth(lane)) - 0.5 * force(lane) * depth(lane);
    }
    return force;
  }

  /// Damping never pulls: what it takes from a separating point ends with the spring's force.
  Lanes add_damping(const OverlapBatch& batch, const Lanes& spring, FaceFaceContact& contact) const {
    const Lanes speed =
        evaluate(speed_1_, batch.xi_1, batch.eta_1) - evaluate(speed_2_, batch.xi_2, batch.eta_2);
    Lanes undamped = -penalty_.damping * batch.weight * speed;
    for (int lane = 0; penalty_.pressure != nullptr && lane < n_lanes; ++lane)
      undamped(lane) *= penalty_.damping_factor(-batch.gap(lane));
    const Lanes damping = undamped.max(-spring);
    contact.damped_power -= (damping * speed).sum();
    return damping;
  }

  const OverlapPoints& points_;
  const PairPenalty& penalty_;
  bool touches_;
  FaceFunction speed_1_{}, speed_2_{};
  FaceMoments forces_1_{}, forces_2_{};
  double work_ = 0.0;
};

/// Whether all of the overlap is near, and on one side of where the gap closes.
bool is_uncut(const ProjectedPair& pair, double activation_distance, double depth) {
  return pair.min_gap >= -depth && pair.max_gap <= activation_distance &&
         (pair.max_gap <= 0.0 || pair.min_gap > 0.0);
}

void set_points(const OverlapPolygon& polygon, const ProjectedPair& pair, Overlap& overlap) {
  place_points(polygon, pair.map_1, pair.map_2, overlap.points);
  overlap.points.spread(pair.plane.spread);
}

/// What lies deeper than the depth is another wall, as is what lies behind it.
void find_overlap(const ProjectedPair& pair, double activation_distance, double depth, Overlap& overlap) {
  OverlapPolygon whole = overlap_of(pair);
  const double area = whole.area();
  if (!(area > 0.0)) return;
  if (is_uncut(pair, activation_distance, depth)) {
    overlap.touches = pair.max_gap <= 0.0;
    overlap.near_area = area * pair.plane.spread;
    return set_points(whole, pair, overlap);
  }
  set_gaps(pair.map_1, pair.map_2, whole);
  std::array<OverlapPolygon, 2> for_near, for_behind;
  const OverlapPolygon& near = part_between(-depth, activation_distance, whole, for_near);
  const double near_area = near.area();
  if (!(near_area > 0.0)) return;
  overlap.near_area = near_area * pair.plane.spread;
  const OverlapPolygon& behind = part_between(-depth, 0.0, near, for_behind);
  overlap.touches = behind.has_area();
  set_points(overlap.touches ? behind : near, pair, overlap);
}

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

FaceFaceContact find_face_face_contact(const MovingFace& first, const MovingFace& second,
                                       const PairPenalty& penalty, double activation_distance) {
  FaceFaceContact contact;
  auto pair = project_pair(first, second);
  if (!pair || !is_near(*pair, activation_distance, penalty.depth)) return contact;
  make_maps(first, second, *pair);
  Overlap overlap;
  find_overlap(*pair, activation_distance, penalty.depth, overlap);
  if (!(overlap.points.area > 0.0)) return contact;
  PressureSums sums(overlap, penalty);
  if (penalty.damping > 0.0) sums.set_damping(first, second, pair->plane.normal);
  sums.add(contact);
  contact.stiffness *= overlap.near_area;
  contact.overlaps = contact.gap < activation_distance && -contact.gap <= penalty.depth;
  if (!contact.overlaps) return contact;
  contact.normal = pair->plane.normal;
  contact.weights_1 = sums.weights(true, first.is_triangle);
  contact.weights_2 = sums.weights(false, second.is_triangle);
  return contact;
}

bool is_contact_uncut(const MovingFace& first, const MovingFace& second, const PairPenalty& penalty,
                      double activation_distance) {
  const auto pair = project_pair(first, second);
  return pair && is_uncut(*pair, activation_distance, penalty.depth);
}

std::optional<FaceFacePoints> find_face_face_points(const MovingFace& first, const MovingFace& second) {
  auto pair = project_pair(first, second);
  if (!pair || !boxes_meet(pair->first, pair->second)) return std::nullopt;
  make_maps(first, second, *pair);
  const OverlapPolygon overlap = overlap_of(*pair);
  if (!overlap.has_area()) return std::nullopt;
  FaceFacePoints found{pair->plane, {}, first.is_triangle, second.is_triangle};
  place_points(overlap, pair->map_1, pair->map_2, found.points);
  return found;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/smoothing/smooth_overlap.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "contact/smoothing/smooth_overlap_points.hpp"
#include "core/interface_laws/pressure_law.hpp"

namespace contactsim {

namespace {

/// Adds f at a point to sums over a face.
void add_moments(double f, double xi, double eta, FaceMoments& moments) {
  moments[0] += f;
  moments[1] += f * xi;
  moments[2] += f * eta;
  moments[3] += f * xi * eta;
}

/// Sums of something over the points of an overlap.
struct SurfaceSums {
  FaceMoments on_first{}, on_second{};
  double gap = 0.0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(), middle = Eigen::Vector3d::Zero();

  void add(double f, const SurfacePairPoint& point) {
    add_moments(f, point.xi_1, point.eta_1, on_first);
    add_moments(f, point.xi_2, point.eta_2, on_second);
    gap += f * point.gap;
    normal += f * point.normal;
    middle += f * point.middle;
  }
  double sum() const { return on_first[0]; }
};

/// Changes the weights of a face's corners by as little as brings their point onto a line: with w + e, the
/// sum of e is 0 and that of e_i x_i is the way to the line, square to it.
///   x  a point of the line
Eigen::Vector4d onto_line(const MovingFace& face, const Eigen::Vector4d& weights, const Eigen::Vector3d& x,
                          const Eigen::Vector3d& direction) {
  const FaceCorners arms = face.x.colwise() - x;
  const Eigen::Vector3d across = direction.unitOrthogonal(), along = direction.cross(across);
  Eigen::Matrix<double, 3, 4> sums;
  sums.row(0).setOnes();
  sums.row(1) = across.transpose() * arms;
  sums.row(2) = along.transpose() * arms;
  if (face.is_triangle) sums.col(3).setZero();
  // Lengths of the face's size, so that the three rows weigh alike.
  const double size = sums.bottomRows<2>().norm();
  sums.bottomRows<2>() /= size;
  const Eigen::Vector3d wanted = Eigen::Vector3d::UnitX() - sums * weights;
  const Eigen::Matrix3d squares = sums * sums.transpose();
  return weights + sums.transpose() * (squares.inverse() * wanted);
}

/// The weights of both faces' corners, from sums.
struct SurfaceWeights {
  Eigen::Vector4d first, second;
  Eigen::Vector3d normal;
  SurfaceWeights(const SmoothPatch& a, const SmoothPatch& b, const SurfaceSums& sums) {
    normal = sums.normal.normalized();
    const Eigen::Vector3d middle = sums.middle / sums.sum();
    first = onto_line(a.face(), corner_shares(sums.on_first, a.is_triangle()) / sums.sum(), middle, normal);
    second = onto_line(b.face(), corner_shares(sums.on_second, b.is_triangle()) / sums.sum(), middle, normal);
  }
};

/// Part of an overlap from which on it has a point for each corner of the smaller face, and below which it
/// has none, over that face's area; the numbers of its points. As of find_face_face_constraints().
constexpr double large = 0.5, negligible_share = 1e-6;
constexpr std::uint8_t first_corners = 0, second_corners = 4, whole_overlap = 8;

/// Sums by the shape functions of the smaller face's corners.
struct CornerSums {
  bool is_of_first;
  SurfaceSums whole;
  std::array<SurfaceSums, 4> of_corner;
  double area = 0.0;  // in the plane [length^2]

  void add(double f, const SurfacePairPoint& point, bool is_triangle) {
    area += f / point.spread;
    whole.add(f, point);
    const Eigen::Vector4d shape = is_of_first ? corner_weights(point.xi_1, point.eta_1, is_triangle)
                                              : corner_weights(point.xi_2, point.eta_2, is_triangle);
    for (std::size_t k = 0; k < 4; ++k) of_corner[k].add(f * shape[static_cast<Eigen::Index>(k)], point);
  }
};

OverlapShare share_of(const SmoothPatch& first, const SmoothPatch& second, const SurfaceSums& sums,
                      std::uint8_t part) {
  const SurfaceWeights weights(first, second, sums);
  const Eigen::Vector3d origin = second.face().x.col(0);  // large coordinates would cost digits
  const double of_corners = weights.normal.dot((first.face().x.colwise() - origin) * weights.first -
                                               (second.face().x.colwise() - origin) * weights.second);
  return {sums.sum(),     weights.normal, weights.first,
          weights.second, part,           sums.gap / sums.sum() - of_corners};
}

/// The energy per area that the pressure at a depth stores.
double potential_at(const PairPenalty& penalty, double depth) {
  return penalty.pressure == nullptr ? penalty.stiffness * penalty.law.potential(depth)
                                     : penalty.pressure->potential(depth);
}

}  // namespace

FaceFaceContact find_smooth_contact(const SmoothSides& sides, const PairPenalty& penalty,
                                    double activation_distance) {
  FaceFaceContact contact;
  const SmoothOverlap overlap(sides, 0.0);
  if (!overlap.has_area() || !overlap.may_hold({-penalty.depth, activation_distance})) return contact;
  SurfaceSums forces, areas;
  double work = 0.0;
  contact.gap = std::numeric_limits<double>::infinity();
  overlap.visit_part({-penalty.depth, 0.0}, [&](double area, const SurfacePairPoint& point) {
    const double depth = std::max(0.0, -point.gap);
    double force = area * penalty.pressure_at(depth);
    contact.beyond_spring += area * potential_at(penalty, depth) - 0.5 * force * depth;
    if (penalty.damping > 0.0) {
      const double speed = point.normal.dot(sides.first.velocity_at(point.xi_1, point.eta_1) -
                                            sides.second.velocity_at(point.xi_2, point.eta_2));
      const double undamped = -penalty.damping * penalty.damping_factor(depth) * speed * area;
      const double damping = std::max(undamped, -force);
      contact.damped_power -= damping * speed;
      force += damping;
    }
    contact.area += area;
    contact.gap = std::min(contact.gap, point.gap);
    work += force * depth;
    forces.add(force, point);
    areas.add(area, point);
  });
  double near_area = contact.area;
  if (activation_distance > 0.0) {
    near_area = 0.0;
    SurfaceSums near;
    overlap.visit_part({-penalty.depth, activation_distance},
                       [&](double area, const SurfacePairPoint& point) {
                         near_area += area;
                         near.add(area, point);
                         if (contact.area == 0.0) contact.gap = std::min(contact.gap, point.gap);
                       });
    if (contact.area == 0.0) areas = near;
  }
  contact.stiffness = penalty.slope(penalty.closing - contact.gap) * near_area;
  contact.overlaps = near_area > 0.0;
  if (!contact.overlaps) return contact;
  const SurfaceWeights weights(sides.first, sides.second, forces.sum() > 0.0 ? forces : areas);
  contact.normal = weights.normal;
  contact.weights_1 = weights.first;
  contact.weights_2 = weights.second;
  if (forces.sum() > 0.0) {
    contact.deepest = -contact.gap;
    contact.force = forces.normal.norm();
    contact.gap = -work / forces.sum();
  }
  return contact;
}

FaceFaceConstraints find_smooth_constraints(const SmoothSides& sides,
                                            const ConstraintActivation& activation) {
  const auto& [first, second, offset] = sides;
  FaceFaceConstraints found;
  const SmoothOverlap overlap(sides, activation.ahead);
  const double reach = std::max(activation.near, activation.margin);
  if (!overlap.has_area() || !overlap.may_hold({-activation.depth, reach})) return found;
  const auto area_of = [&](const SmoothPatch& patch) {
    return std::abs(area_vector(patch.face().x).dot(overlap.plane().normal));
  };
  const double area_1 = area_of(first), area_2 = area_of(second), smaller = std::min(area_1, area_2);
  const bool is_of_first = area_1 <= area_2;
  const bool is_triangle = is_of_first ? first.is_triangle() : second.is_triangle();
  const auto gather = [&](double most) {
    CornerSums sums{is_of_first, {}, {}, 0.0};
    overlap.visit_part({-activation.depth, most}, [&](double area, const SurfacePairPoint& point) {
      sums.add(area, point, is_triangle);
    });
    return sums;
  };
  CornerSums sums = gather(activation.margin);
  if (!(sums.area > 0.0) && reach > activation.margin) sums = gather(reach);
  if (!(sums.area > negligible_share * smaller)) return found;
  if (sums.area < large * smaller) {
    found.add(share_of(first, second, sums.whole, whole_overlap));
    return found;
  }
  for (std::size_t k = 0; k < (is_triangle ? 3 : 4); ++k) {
    if (!(sums.of_corner[k].sum() > negligible_share * sums.whole.sum())) continue;
    const std::size_t part = (is_of_first ? first_corners : second_corners) + k;
    found.add(share_of(first, second, sums.of_corner[k], static_cast<std::uint8_t>(part)));
  }
  return found;
}

CornerShares find_smooth_corner_shares(const SmoothSides& sides, bool is_of_first) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const SmoothPatch &first = sides.first, &second = sides.second;
  const bool is_triangle = is_of_first ? first.is_triangle() : second.is_triangle();
  CornerShares found;
  const SmoothOverlap overlap(sides, 0.0);
  if (!overlap.has_area()) return found;
  CornerSums sums{is_of_first, {}, {}, 0.0};
  overlap.visit_part({-infinite, infinite},
                     [&](double area, const SurfacePairPoint& point) { sums.add(area, point, is_triangle); });
  for (std::size_t k = 0; k < (is_triangle ? 3 : 4); ++k) {
    if (sums.of_corner[k].sum() > negligible_share * sums.whole.sum())
      found.add(share_of(first, second, sums.of_corner[k], static_cast<std::uint8_t>(k)));
  }
  return found;
}

void bring_onto_line(const MovingFace& first, const MovingFace& second, const Eigen::Vector3d& place,
                     FaceFaceContact& contact) {
  contact.weights_1 = onto_line(first, contact.weights_1, place, contact.normal);
  contact.weights_2 = onto_line(second, contact.weights_2, place, contact.normal);
}

std::optional<SmoothGap> find_smooth_gap(const SmoothSides& sides) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const SmoothOverlap overlap(sides, 0.0);
  if (!overlap.has_area()) return std::nullopt;
  SmoothGap found;
  found.smallest = infinite;
  overlap.visit_part({-infinite, infinite}, [&](double area, const SurfacePairPoint& point) {
    found.area += area;
    found.mean += area * point.gap;
    found.smallest = std::min(found.smallest, point.gap);
  });
  if (!(found.area > 0.0)) return std::nullopt;
  found.mean /= found.area;
  return found;
}

}  // namespace contactsim

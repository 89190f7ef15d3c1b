// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/face_bound.hpp"

#include <algorithm>
#include <cmath>

#include "contact/geometry/common_plane.hpp"

namespace contactsim {

namespace {

/// Share of lengths that single precision may lose: what it says must not be no where double precision says
/// yes.
constexpr float rounding = 2e-6f;
constexpr float max_facing_cosine_rounded = static_cast<float>(max_facing_cosine_of_blade) + rounding;

/// How far a parallelogram reaches along a direction, from the products of its halves with it.
float reach_along(float half_1, float half_2) { return std::abs(half_1) + std::abs(half_2); }

/// Mean of the corners, each of a triangle's once.
Eigen::Vector3d mean(const FaceCorners& x, bool is_triangle) {
  if (is_triangle) return (x.col(0) + x.col(1) + x.col(2)) / 3.0;
  return 0.25 * (x.col(0) + x.col(1) + x.col(2) + x.col(3));
}

}  // namespace

FaceBound::FaceBound(const FaceCorners& x, const FaceCorners& v, bool is_triangle, float height, float lean)
    : centre_(mean(x, is_triangle)), lean_(lean) {
  const Eigen::Matrix<float, 3, 4> away = (x.colwise() - centre_).cast<float>();
  const Eigen::Vector3f p = away.col(2) - away.col(0), q = away.col(1) - away.col(3);
  radius_ = std::sqrt(away.colwise().squaredNorm().maxCoeff());
  set(2, q.cross(p).normalized());
  const Eigen::Vector3d velocity = mean(v, is_triangle);
  set(3, velocity.cast<float>());
  normal_velocity_spread_ = (normal().transpose() * (v.colwise() - velocity).cast<float>()).maxCoeff();
  if (is_triangle) {
    set(0, 0.5f * (away.col(1) - away.col(0)));
    set(1, 0.5f * p);
    // The parallelogram of a triangle has its middle elsewhere.
    warp_ = (half(0) + half(1)).norm() / 3.0f;
  } else {
    set(0, 0.25f * (p + q));
    set(1, 0.25f * (p - q));
    warp_ = 0.5f * (away.col(0) + away.col(2)).norm();
  }
  warp_ += height;
}

/// The normal is that of w = q x p, p and q as in the constructor. With corners that move by d, w changes by
/// no more than c = 2 d (|p| + |q|) + 4 d^2, and its direction by c / (|w| - c).
float largest_turn(const FaceBound& face, bool is_triangle, double motion) {
  constexpr float more = 1.0f + 2.0f * rounding, any = 2.0f;
  const auto d = static_cast<float>(motion);
  // Half of q and of p.
  const Eigen::Vector3f across = face.half(0) - face.half(1),
                        along = is_triangle ? face.half(1) : Eigen::Vector3f(face.half(0) + face.half(1));
  const float w = 4.0f * across.cross(along).norm();
  const float change = 4.0f * d * (across.norm() + along.norm() + d) * more;
  return change < 0.5f * w ? change / (w - change) * more : any;
}

bool may_touch(const FaceBound& a, const FaceBound& b, double activation_distance) {
  const Eigen::Vector3f apart = (a.centre() - b.centre()).cast<float>();
  const FourFloats on_b = b.times(apart), normal = a.times(b.normal());
  if (normal[2] > max_facing_cosine_rounded) return false;
  const float size = a.radius() + b.radius(), warp = a.warp() + b.warp(), height = on_b[2];
  const float thick = std::abs(normal[0]) + std::abs(normal[1]) + warp;
  if (height > static_cast<float>(activation_distance) + thick + rounding * size) return false;
  // Seen along the common normal instead of the second face's, points move by this much.
  const float tilt = (a.normal() + b.normal()).norm();
  const float slack = warp + tilt * (std::abs(height) + 0.25f * size) + rounding * size;
  const FourFloats on_a = a.times(apart);
  const std::array<FourFloats, 2> a_b{a.times(b.half(0)), a.times(b.half(1))};
  const std::array<FourFloats, 2> a_a{a.times(a.half(0)), a.times(a.half(1))};
  const std::array<FourFloats, 2> b_b{b.times(b.half(0)), b.times(b.half(1))};
  for (std::size_t i = 0; i < 2; ++i) {
    const float room_b = reach_along(a_b[i][0], a_b[i][1]) + reach_along(b_b[i][0], b_b[i][1]);
    const float room_a = reach_along(a_b[0][i], a_b[1][i]) + reach_along(a_a[i][0], a_a[i][1]);
    if (std::abs(on_b[i]) > room_b + slack * std::sqrt(b_b[i][i])) return false;
    if (std::abs(on_a[i]) > room_a + slack * std::sqrt(a_a[i][i])) return false;
  }
  return true;
}

bool may_project_inside(const Eigen::Vector3d& point, const FaceBound& face, double activation_distance,
                        double depth, double beyond) {
  const Eigen::Vector3f away = (point - face.centre()).cast<float>();
  const FourFloats on_face = face.times(away);
  const float height = on_face[2], size = face.radius() + std::abs(height);
  const float rough = face.warp() + rounding * size;
  if (height > static_cast<float>(activation_distance) + rough || height < -static_cast<float>(depth) - rough)
    return false;
  // The closest point of a point off a warped face lies aside by as much as its normal turns.
  const float turned = face.warp() / face.radius();
  const float slack = rough + static_cast<float>(beyond) + (2.0f * turned + face.lean()) * std::abs(height);
  for (std::size_t i = 0; i < 2; ++i) {
    const FourFloats along = face.times(face.half(i));
    if (std::abs(on_face[i]) > reach_along(along[0], along[1]) + slack * std::sqrt(along[i])) return false;
  }
  return true;
}

}  // namespace contactsim

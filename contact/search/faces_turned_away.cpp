// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/faces_turned_away.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "contact/geometry/common_plane.hpp"
#include "core/base/state_archive.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

namespace {

/// By which the unit normal of a face may change until the next search [1].
constexpr float allowed_turn = 0.08f;

/// Of directions in single precision [1].
constexpr float rounding_of_cosine = 1e-5f;

/// By how much the normals of what stands for a face lean on its own, at most: facets of a warped
/// quadrilateral, and the surface that a smoothed one stands for [1].
float lean_of(const ContactFace& face, const FaceBound& bound) {
  const float facets = face.is_triangle() ? 0.0f : 2.0f * bound.warp() / bound.radius();
  return facets + bound.lean();
}

Eigen::Vector3f normal_of(const ContactKinematics& kinematics, FaceIndex face) {
  return kinematics.area(kinematics.contact_mesh().faces[face]).normalized().cast<float>();
}

}  // namespace

bool FacesTurnedAway::are(const ContactKinematics& kinematics, FaceIndex a, FaceIndex b) {
  const ContactFace &first = kinematics.contact_mesh().faces[a], &second = kinematics.contact_mesh().faces[b];
  const FaceBound &of_first = kinematics.bound(a), &of_second = kinematics.bound(b);
  // The cosine of both normals changes by 2 t + t^2 at most when each changes by t.
  constexpr float turns = 2.0f * allowed_turn + allowed_turn * allowed_turn;
  const auto facing =
      static_cast<float>(facing_limit(static_cast<double>(std::max(first.sharpness, second.sharpness))));
  const float cosine = of_first.normal().dot(of_second.normal());
  if (!(cosine > facing + turns + rounding_of_cosine + lean_of(first, of_first) + lean_of(second, of_second)))
    return false;
  for (const FaceIndex face : {a, b}) std::atomic_ref(marks_[face]).store(1, std::memory_order_relaxed);
  return true;
}

void FacesTurnedAway::finish(const ContactKinematics& kinematics, Ranks& ranks) {
  ranks.unite(marks_);
  watched_.clear();
  for (const FaceIndex face : indices(marks_)) {
    if (marks_[face] != 0) watched_.push_back(face);
  }
  normals_.resize(watched_.size());
  parallel_for(watched_.size(), threads_for(watched_.size()),
               [&](std::size_t i) { normals_[i] = normal_of(kinematics, watched_[i]); });
}

/// A normal is that of w = q x p, p and q the diagonals of the corners. Where these move by d, w changes by
/// no more than c = 2 d l + 4 d^2, l = |p| + |q|, and its direction by c / (|w| - c): by t where
/// c = |w| t / (1 + t).
double FacesTurnedAway::room(const ContactKinematics& kinematics) const {
  constexpr double infinite = std::numeric_limits<double>::infinity(), safe = 0.99;
  return parallel_min(watched_.size(), threads_for(watched_.size()), infinite, [&](std::size_t i) {
    const FaceCorners x = kinematics.face_corners(watched_[i]);
    const Eigen::Vector3d area = area_vector(x);
    const float turned = (area.normalized().cast<float>() - normals_[i]).squaredNorm();
    if (!(turned <= allowed_turn * allowed_turn)) return -1.0;  // what is not a number has turned
    const double left = static_cast<double>(allowed_turn - std::sqrt(turned) - rounding_of_cosine);
    if (!(left > 0.0)) return 0.0;
    const double l = (x.col(2) - x.col(0)).norm() + (x.col(3) - x.col(1)).norm();
    const double c = 2.0 * area.norm() * left / (1.0 + left);
    return 0.25 * safe * (std::sqrt(l * l + 4.0 * c) - l);
  });
}

void FacesTurnedAway::archive(StateArchive& saved) {
  // States of runs without such faces have nothing of them.
  if (saved.restores() ? !saved.has("contact/search/turned_away") : watched_.empty()) {
    watched_.clear();
    normals_.clear();
    return;
  }
  saved.list("contact/search/turned_away", watched_);
  saved.list("contact/search/normals", normals_);
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/faces_turned_away.hpp"

#include <algorithm>
#include <atomic>

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

namespace {

/// Whether the cosine of the normals of two faces stays above a limit.
bool stays_above(const ContactKinematics& kinematics, FaceIndex a, FaceIndex b, double limit) {
  const FaceBound &first = kinematics.bound(a), &second = kinematics.bound(b);
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  const float lean = lean_of(contact_mesh.faces[a], first) + lean_of(contact_mesh.faces[b], second);
  // The cosine changes by 2 t + t^2 at most when each normal changes by t.
  constexpr float turns = 2.0f * allowed_turn + allowed_turn * allowed_turn;
  return first.normal().dot(second.normal()) > static_cast<float>(limit) + turns + rounding_of_cosine + lean;
}

}  // namespace

void FacesTurnedAway::watch(FaceIndex face) {
  std::atomic_ref(marks_[face]).store(1, std::memory_order_relaxed);
}

bool FacesTurnedAway::are(const ContactKinematics& kinematics, FaceIndex a, FaceIndex b) {
  const auto& faces = kinematics.contact_mesh().faces;
  const auto sharpness = static_cast<double>(std::max(faces[a].sharpness, faces[b].sharpness));
  if (!stays_above(kinematics, a, b, facing_limit(sharpness))) return false;
  for (const FaceIndex face : {a, b}) watch(face);
  return true;
}

bool FacesTurnedAway::are(const ContactKinematics& kinematics, const SurfaceNode& node, FaceIndex face) {
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  const auto visit_own = [&](const auto& visit) {
    for (const FaceIndex own : contact_mesh.faces_of_node.of(node.node)) {
      if (contact_mesh.faces[own].surface == node.surface) visit(own);
    }
  };
  bool has_faces = false, are_all = true;
  visit_own([&](FaceIndex own) {
    has_faces = true;
    are_all = are_all && stays_above(kinematics, own, face, max_facing_cosine_of_blade);
  });
  if (!has_faces || !are_all) return false;
  watch(face);
  visit_own([&](FaceIndex own) { watch(own); });
  return true;
}

void FacesTurnedAway::finish(const ContactKinematics& kinematics) {
  watched_.clear();
  for (const FaceIndex face : indices(marks_)) {
    if (marks_[face] != 0) watched_.push_back(face);
  }
  normals_.resize(watched_.size());
  parallel_for(watched_.size(), threads_for(watched_.size()),
               [&](std::size_t i) { normals_[i] = normal_of(kinematics, watched_[i]); });
}

bool FacesTurnedAway::have_turned(const ContactKinematics& kinematics) const {
  const float most = parallel_max(watched_.size(), threads_for(watched_.size()), 0.0f, [&](std::size_t i) {
    const float turned = (normal_of(kinematics, watched_[i]) - normals_[i]).squaredNorm();
    return turned <= 4.0f ? turned : 4.0f;  // what is not a number has turned
  });
  return most > allowed_turn * allowed_turn;
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

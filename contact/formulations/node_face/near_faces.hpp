// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>

#include "contact/formulations/node_face/node_face_contacts.hpp"
#include "contact/formulations/penalty.hpp"
#include "contact/geometry/node_face.hpp"

namespace contactsim {

inline bool has_corner(const ContactFace& face, ContactNodeIndex node) {
  return std::ranges::find(face.corners, node) != face.corners.end();
}

/// A face that a node may touch as far as bounds tell.
struct NodeFaceContacts::FaceInReach {
  SurfaceNodeIndex row;
  FaceIndex face;
  PairIndex pair;
  const PairRule* rule = nullptr;
  NodeHistory node_history;
  double offset = 0.0, deeper = 0.0;  ///< see NodeReach [length]
  bool keeps_plane = false;           ///< it is a face of the start that the node slides over
};

/// A face that a node may touch.
struct NodeFaceContacts::NearFace {
  FaceIndex face;
  PairIndex pair;
  ClosestPoint point;
  /// Of the face's corners at the point, sum 1 [1]. Sorting copies to memory that is aligned for numbers
  /// only.
  Eigen::Matrix<double, 4, 1, Eigen::DontAlign> weights;
  PairPenalty penalty;
  double share = 1.0;     ///< of the node's area, where it projects inside several faces alike [1]
  double distance = 0.0;  ///< of the node, the middle of a sphere, from the face [length]
  double near = 0.0;      ///< gaps up to it may close soon [length]
  bool is_plane = false;  ///< the node projects onto the plane of the face, beyond its edges
  double beyond = 0.0;    ///< by so much [length]
  bool pulls = false;     ///< it has touched and may not part
  double deeper = 0.0;    ///< by the node's multiplier [length]
};

/// The few faces that a node is near to. More than fit are left out, the ones found last.
struct NodeFaceContacts::NearFaces {
  static constexpr std::size_t max_faces = 16;

  std::array<NearFace, max_faces> all;
  std::size_t n = 0;

  void add(const NearFace& near_face) {
    if (n < max_faces) all[n++] = near_face;
  }
  auto begin() { return all.begin(); }
  auto end() { return all.begin() + static_cast<std::ptrdiff_t>(n); }
};

}  // namespace contactsim

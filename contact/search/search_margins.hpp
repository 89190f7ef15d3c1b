// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "contact/mesh/contact_kinematics.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

class StateArchive;

/// The margins by which the boxes of a search are wider than what is in them, and how much of them nodes have
/// used up by their motion since. All calls are to have the same contact mesh, until the next set().
class SearchMargins {
 public:
  /// The margin of a face is a share of the root of its area, that of a node the least of its faces' and of
  /// the same share of the root of its own area, as the mesh is at the start. A search has to follow.
  ///   share  [1]
  void set(const ContactMesh& contact_mesh, const Mesh& mesh, double share);
  /// Margins [length].
  float of(FaceIndex face) const { return of_face_[face]; }
  float of(ContactNodeIndex node) const { return of_node_[node]; }

  /// To be called at each search: motion counts from here.
  void start_at(const ContactMesh& contact_mesh, const ContactKinematics& kinematics);
  /// The largest motion of a node of each surface since then, over its margin; NaN where a node has no finite
  /// position. The same for any number of threads [n_surfaces] [1].
  IndexedVector<SurfaceIndex, double> used(const ContactMesh& contact_mesh,
                                           const ContactKinematics& kinematics) const;
  /// Whether the margins that two surfaces have used leave room between all their faces: what one has used
  /// beyond its own, at its widest, the other has left at its narrowest.
  bool has_room(SurfaceIndex first, double first_used, SurfaceIndex second, double second_used) const;

  /// How far nodes may still move until the margins of a surface may be used up [length].
  double room(const IndexedVector<SurfaceIndex, double>& used) const;

  /// Saves or restores where nodes were, with the number of searches so far.
  void archive(std::uint64_t& n_searches, StateArchive& saved);
  std::size_t bytes() const { return bytes_of(of_face_) + bytes_of(of_node_) + bytes_of(started_at_); }

 private:
  double used_by(const ContactKinematics& kinematics, ContactNodeIndex node) const;

  IndexedVector<FaceIndex, float> of_face_;                      // [length]
  IndexedVector<ContactNodeIndex, float> of_node_;               // [length]
  IndexedVector<SurfaceIndex, double> widest_, narrowest_;       // [length]
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();             // near the nodes at the last search [length]
  IndexedVector<ContactNodeIndex, Eigen::Vector3f> started_at_;  // at the last search, from there [length]
};

}  // namespace contactsim

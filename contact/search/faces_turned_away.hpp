// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "contact/mesh/contact_kinematics.hpp"
#include "core/base/bytes_of.hpp"
#include "core/base/indexed_vector.hpp"
#include "core/parallel/ranks.hpp"

namespace contactsim {

class StateArchive;

/// Faces that are near others but turned away from them. Such pairs, most of those whose boxes meet, are no
/// candidates as long as neither face has turned by more than a little since the last search.
class FacesTurnedAway {
 public:
  /// Begins a search: bounds of all faces are those of now.
  void begin(const ContactKinematics& kinematics) {
    marks_.assign(kinematics.contact_mesh().faces.size(), 0);
  }
  /// Whether two faces will not face each other as long as room() is left; both are watched then. May be
  /// called by several threads.
  bool are(const ContactKinematics& kinematics, FaceIndex a, FaceIndex b);
  /// Ends a search, which ranks may have made together: turns count from here.
  void finish(const ContactKinematics& kinematics, Ranks& ranks = one_rank());
  /// How far nodes may still move until a watched face may have turned too far for what are() has said; < 0
  /// where one has [length].
  double room(const ContactKinematics& kinematics) const;

  void archive(StateArchive& saved);
  std::size_t bytes() const { return bytes_of(marks_) + bytes_of(watched_) + bytes_of(normals_); }

 private:
  IndexedVector<FaceIndex, std::uint8_t> marks_;  // of the search under way
  std::vector<FaceIndex> watched_;
  std::vector<Eigen::Vector3f> normals_;  // [watched] at the last search [1]
};

}  // namespace contactsim

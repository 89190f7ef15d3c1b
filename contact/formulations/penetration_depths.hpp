// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "contact/geometry/contact_point.hpp"
#include "contact/mesh/contact_kinematics.hpp"
#include "contact/mesh/contact_remap.hpp"

namespace contactsim {

/// How deep every face penetrated another side in the last step, or another side's nodes it.
class PenetrationDepths {
 public:
  /// The depth of a face in the last step; > 0 of all that touched, 0 of one that did not [length].
  double of(FaceIndex face) const { return face < last_.next() ? last_[face] : 0.0; }
  /// Whether some face with this corner touched in the last step.
  bool has_touched_at(ContactNodeIndex corner) const { return has_touched_[corner] != 0; }

  /// Begins a step: what was noted becomes what is known.
  void begin_step(const ContactMesh& contact_mesh);
  /// The opposite, before the first note().
  void undo_begin_step() { std::swap(last_, next_); }
  /// Adds a contact point to what is known of its faces in the next step. Of a node these are the faces of
  /// its surface that are turned towards the other side.
  void note(const ContactKinematics& kinematics, const ContactPoint& point);
  /// Goes over to other faces.
  void remap(const ContactRemap& remap);
  void archive(StateArchive& saved);

 private:
  IndexedVector<FaceIndex, double> last_, next_;               // [length]
  IndexedVector<ContactNodeIndex, std::uint8_t> has_touched_;  // [n_contact_nodes] of last_
};

}  // namespace contactsim

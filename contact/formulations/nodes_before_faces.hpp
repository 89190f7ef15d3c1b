// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "contact/geometry/node_face.hpp"
#include "contact/interface_laws/pair_rules.hpp"
#include "contact/mesh/contact_kinematics.hpp"
#include "contact/search/contact_search.hpp"

namespace contactsim {

/// A surface node that projects inside a face that its surface meets, at any distance of a search.
struct NodeBeforeFace {
  PairIndex pair;
  SurfaceNodeIndex row;
  FaceIndex face;
  ClosestPoint point;
  double gap = 0.0;  ///< that counts, less what the pair takes off [length]
};

/// Calls take(node) for all of active pairs, of NODE_FACE and of the corners of FACE_FACE, in an order that
/// does not depend on threads; some of them more than once.
///   search      its own, whose candidates are found anew
///   kinematics  bounds of all faces are those of now
void visit_nodes_before_faces(ContactSearch& search, const ContactKinematics& kinematics,
                              const PairRules& rules, const Motion& motion,
                              const std::function<void(const NodeBeforeFace&)>& take);

}  // namespace contactsim

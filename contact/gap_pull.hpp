// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/contact_place.hpp"
#include "contact/place_law.hpp"

/// Laws that act across a gap: adhesion and junctions. Their potential is 0 where the sides do not feel each
/// other, so that it is negative at closed sides. A
/// force along the surface leaves its moment over the gap, as friction does over a penetration.
namespace contactsim {

/// Adds what a law does to a node, touching or not, to its record: pull, potential, the force along the
/// surface and their stiffness.
///   record  push_node has seen it; its elastic slip is that of the last step
void pull_node(const PlaceLaw& law, const NodePush& push, ContactRecord& record);

/// Two faces before each other.
struct FacePush {
  MovingFace first, second;
  PairPenalty penalty;
  double dt = 0.0;  ///< [time]
};

/// The same of two faces, in a record of its own beside that of the penalty. Returns whether some point feels
/// the law; the record is filled in but for its pair and places then.
bool pull_faces(const PlaceLaw& law, const FacePush& push, ContactRecord& record);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/formulations/contact_point_law.hpp"
#include "core/interface_laws/interface_law.hpp"

/// Laws that act across a gap: adhesion and junctions. Their potential is 0 where the sides do not feel each
/// other, so that it is negative at closed sides. A
/// force along the surface leaves its moment over the gap, as friction does over a penetration.
namespace contactsim {

/// Adds what a law does to a node, touching or not, to its contact point: pull, potential, the force along
/// the surface and their stiffness.
///   point  push_node has seen it; its elastic slip is that of the last step
void add_node_traction(const InterfaceLaw& law, const NodePenaltyInput& push, ContactPoint& point);

/// Two faces before each other.
struct FacePenaltyInput {
  MovingFace first, second;
  PairPenalty penalty;
  double dt = 0.0;  ///< [time]
};

/// The same of two faces, in a contact point of its own beside that of the penalty. Returns whether some
/// point feels the law; the contact point is filled in but for its pair and entities then.
bool add_face_traction(const InterfaceLaw& law, const FacePenaltyInput& push, ContactPoint& point);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "contact/interface_laws/pair_rules.hpp"
#include "contact/mesh/contact_kinematics.hpp"
#include "core/definition/contact_options.hpp"

namespace contactsim {

/// How far every contact node is from what its surface meets now, touching or not: the gap that counts to the
/// nearest face over which it stands, or plane, of all active pairs. What is farther than the pair's TRACKING
/// DISTANCE, without one than the margin of the search, has that: the gap is at least so wide. A search of
/// its own, which changes nothing. Edges and lines among each other are not looked at.
///   kinematics  bounds of all faces are those of now
/// Returns [n_contact_nodes] [length]; 0 of nodes whose surfaces meet nothing.
/// Source: *SURFACE INTERACTION, TRACKING THICKNESS and COPEN of Abaqus.
IndexedVector<ContactNodeIndex, double> find_node_gaps(const ContactKinematics& kinematics, const Mesh& mesh,
                                                       const PairRules& rules, const DashOptions& dash,
                                                       const Motion& motion);

}  // namespace contactsim

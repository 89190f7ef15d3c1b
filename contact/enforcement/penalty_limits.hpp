// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/enforcement/contact_mobility.hpp"
#include "contact/mesh/contact_kinematics.hpp"
#include "contact/mesh/contact_mesh.hpp"

namespace contactsim {

/// Contact may add this share of the elements' largest eigenvalue of stiffness over mass, by its automatic
/// stiffness: the stable step shrinks by a tenth at most.
inline constexpr double penalty_share = 0.25;

/// The stiffness of the penalty in load steps over that of explicit dynamics: no stable step limits it, and
/// it leaves a few hundredths of what an element gives way by.
inline constexpr double static_penalty_scale = 10.0;

/// Says what is rigid, held or driven, and lowers the stiffness behind faces and nodes where nodes are too
/// light for it: a node of mass m and contact area A, as seen along the face's normal, gets no more than
/// 4 share m / (A dt^2) per area, twice what it may have against a wall as soft as itself. The sides of a
/// block do not lower the limit of its top, which would be softer at its edges then and fail the patch test.
/// Nodes that are held along the normal have no limit.
///   surface      the faces at the start
///   mobility     of the conditions that act now
///   stable_step  that the elements allow at the start, dt [time]
///   faces        with the stiffness of their elements
/// Source: bound on the frequency of a mass between springs; Belytschko and Neal, Int. J. Numer. Meth. Eng.
/// 31 (1991) 547-572, choose the penalty by masses and step likewise.
void limit_stiffness(const ContactKinematics& kinematics, const ContactMobility& mobility, double stable_step,
                     ContactMesh& contact_mesh);

}  // namespace contactsim

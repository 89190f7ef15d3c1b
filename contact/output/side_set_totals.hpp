// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/output/contact_output.hpp"

namespace contactsim {

/// What contact does to the faces of a side set, whatever surfaces they belong to. Of a force on a node of
/// the surface the set gets the part of the faces about the node that are in the set, by how much of them
/// looks against the normal; of two edges half for each of the faces about them. So a set of all faces of a
/// surface has the totals of the surface.
///   sides  of the set, ascending
ContactTotal sum_over_sides(const ContactForce& force, std::span<const ElementSide> sides);

}  // namespace contactsim

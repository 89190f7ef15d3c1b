// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "contact/geometry/contact_point.hpp"
#include "contact/mesh/contact_mesh.hpp"
#include "contact/mesh/contact_remap.hpp"

/// How deep faces, nodes and edges lay in each other at the start, behind which their penalty gets stiffer.
namespace contactsim {

/// Nothing is known of the start yet: the penalty is a spring at any depth.
void forget_start_depths(ContactMesh& contact_mesh);

/// Takes the depths over from the contact points of the start; 0 where nothing penetrates.
void set_start_depths(std::span<const ContactPoint> points, ContactMesh& contact_mesh);

/// Goes over to other faces; what is new has depth 0.
void transfer_start_depths(const ContactRemap& remap, const ContactMesh& before, ContactMesh& after);

}  // namespace contactsim

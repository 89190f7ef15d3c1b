// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "contact/contact_faces.hpp"
#include "contact/contact_record.hpp"
#include "contact/contact_renumbering.hpp"

/// How deep faces, nodes and edges lay in each other at the start, behind which their penalty gets stiffer.
namespace contactsim {

/// Nothing is known of the start yet: the penalty is a spring at any depth.
void forget_start_depths(ContactFaces& faces);

/// Takes the depths over from the contact points of the start; 0 where nothing penetrates.
void set_start_depths(std::span<const ContactRecord> points, ContactFaces& faces);

/// Goes over to other faces; what is new has depth 0.
void carry_start_depths(const ContactRenumbering& places, const ContactFaces& before, ContactFaces& after);

}  // namespace contactsim

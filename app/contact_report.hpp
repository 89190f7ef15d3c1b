// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "contact/contact_force.hpp"

namespace contactsim {

/// What the search of a run did, what is tied, and how much contact lowered the stable step. Without times of
/// the clock.
std::string format_contact(const ContactForce& contact);

}  // namespace contactsim

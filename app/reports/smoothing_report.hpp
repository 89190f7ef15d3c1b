// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "contact/mesh/contact_model.hpp"

namespace contactsim {

/// The table of the round shapes of surfaces: those of the deck, and what AUTO has found. "" without any.
std::string format_smoothings(const ContactModel& model);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>
#include <string>

namespace contactsim {

/// A time of day, of this place, in strftime's format; "" when the format says nothing or more than 255
/// characters.
std::string format_clock(std::time_t time, const std::string& format);

}  // namespace contactsim

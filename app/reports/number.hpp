// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace contactsim {

/// A number of a table, to six digits; "-" when it is not known.
inline std::string number(double value) { return std::isnan(value) ? "-" : fmt::format("{:.6g}", value); }

}  // namespace contactsim

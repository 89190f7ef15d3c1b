// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace contactsim {

/// The number that a whole text is, also "nan" and "inf"; nothing when it is none.
std::optional<double> read_number(std::string_view text);

/// The same of a whole number.
std::optional<std::int64_t> read_integer(std::string_view text);

}  // namespace contactsim

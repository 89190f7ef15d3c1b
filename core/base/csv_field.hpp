// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace contactsim {

/// A field of a CSV file: quoted when it holds a comma, a quote or a line end. Source: RFC 4180.
std::string csv_field(const std::string& text);

}  // namespace contactsim

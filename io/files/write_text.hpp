// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace contactsim {

/// Writes a whole text file, as OutputPlace does. Throws FileError.
void write_text(const std::string& path, std::string_view text);

}  // namespace contactsim

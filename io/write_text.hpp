// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace contactsim {

/// Writes a whole text file: under another name first, renamed when it is complete, so that no reader ever
/// sees a half. Throws FileError.
void write_text(const std::string& path, std::string_view text);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace contactsim {

/// Text of a file as it may be shown and compared: cut at the first NUL, unprintable characters replaced by
/// '_', blanks around it removed.
std::string clean_text(std::string_view stored);

}  // namespace contactsim

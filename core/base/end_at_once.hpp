// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string_view>

#include "core/base/errors.hpp"

namespace contactsim {

/// Ends the process with a line on standard error. It takes no memory, and may be called by a handler of
/// signals; nothing is cleaned up.
///   parts  of the line, without its end; at most 15
[[noreturn]] void end_at_once(ExitCode code, std::initializer_list<std::string_view> parts);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "core/base/errors.hpp"

namespace contactsim {

/// Runs some work; what it throws is written in one line and becomes an exit code: a file error and lack of
/// memory are the user's to mend (3), a motion that cannot go on is 4, anything else a bug of ours (1). Deck
/// errors have more to say than a line, so the work catches them itself.
///   write_line  takes the line, without its end
ExitCode guard_exit(const std::function<ExitCode()>& work,
                    const std::function<void(const std::string&)>& write_line);

/// Has lack of memory in a loop on threads, or in a library that lets no exception through, end the process
/// as guard_exit() would: with its line on standard error and exit code 3, where C++ would abort.
void end_without_memory();

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace contactsim::test {

/// Has signals that end a process write the calls they came through to standard error first, in the form of
/// the sanitizers; where sanitizers are, they do so themselves.
void install_crash_report();

/// Whether this program has the address sanitizer.
bool is_sanitized();

/// What of a crash report says in a line what happened; "" when nothing does.
std::string headline_of(const std::string& report);

/// Whether the innermost call in a crash report that is neither of the C library nor of the sanitizers
/// is of libnetcdf or libhdf5, or the guard around their calls has reported so.
bool is_of_file_library(const std::string& report);

}  // namespace contactsim::test

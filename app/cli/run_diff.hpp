// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/diff_options.hpp"

namespace contactsim {

/// Compares what the options name, and prints the differences. Returns the exit code: 0 without differences,
/// 1 with some, 2 when a file cannot be read, which is reported on standard error. Throws nothing.
int run_diff(const DiffOptions& options);

}  // namespace contactsim

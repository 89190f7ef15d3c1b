// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/cli/manual_options.hpp"
#include "core/base/errors.hpp"

namespace contactsim {

/// What can be written: "man", "html", "bash", ...
std::vector<std::string> manual_kinds();

/// `contactsim manual`: prints a single file, or writes what was asked for below a folder.
/// Throws FileError when a file cannot be written.
ExitCode run_manual(const ManualOptions& options);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/decompose_options.hpp"
#include "core/base/errors.hpp"

namespace contactsim {

/// `contactsim split`: writes the pieces and prints what is in them. Throws FileError.
ExitCode run_split(const SplitOptions& options);

/// `contactsim join`: writes the file and prints what is in it. Throws FileError.
ExitCode run_join(const JoinOptions& options);

}  // namespace contactsim

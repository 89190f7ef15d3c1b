// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/sweep_options.hpp"

namespace contactsim {

/// Does what `contactsim sweep` is asked for and prints how it goes. Returns the exit code, as the help of
/// the command says. Throws FileError.
int run_sweep(const SweepOptions& options);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/run/run_input.hpp"
#include "core/base/diagnostics.hpp"

namespace contactsim {

/// Adds an error for everything in the region or, where it takes its state over, in the procedure before that
/// would change the motion and that this version does not act on, and a warning for what would not.
void refuse_what_is_missing(const RunInput& input, Diagnostics& diagnostics);

}  // namespace contactsim

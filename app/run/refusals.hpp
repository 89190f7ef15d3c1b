// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/diagnostics.hpp"
#include "core/definition/declarations.hpp"

namespace contactsim {

/// Adds an error for everything in the region that would change the motion and that this version does not act
/// on, and a warning for what would not.
void refuse_what_is_missing(const Procedure& procedure, const Region& region, Diagnostics& diagnostics);

}  // namespace contactsim

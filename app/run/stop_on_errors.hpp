// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/errors.hpp"

namespace contactsim {

/// Throws DeckError with all that was found when an error is among it.
inline void stop_on_errors(const Diagnostics& diagnostics) {
  if (diagnostics.has_errors()) throw DeckError(diagnostics);
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/options.hpp"
#include "app/reports/log.hpp"
#include "core/base/diagnostics.hpp"
#include "core/base/errors.hpp"

namespace contactsim {

/// Takes a deck as far as the options ask: deck, mesh, contact surfaces, run.
///   warnings  gains what was found on the way, to be repeated at the end
/// Throws DeckError, FileError.
ExitCode run_deck(const Options& options, Log& log, Diagnostics& warnings);

}  // namespace contactsim

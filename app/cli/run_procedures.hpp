// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "app/cli/prepared_region.hpp"

namespace contactsim {

/// Runs the procedures of a deck one after another, each from the state of the one before as far as it takes
/// it over; or, at the stage `check`, tells what they would take. All are set up before the first begins, so
/// that what any of them refuses is known. One that fails or is stopped is the last.
/// Throws DeckError, FileError, SolveError, and StoppedBySignal before the first step.
ExitCode run_procedures(const DeckWay& way, std::span<const PreparedRegion> regions);

}  // namespace contactsim

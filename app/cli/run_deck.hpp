// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/options.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/report/report_draft.hpp"
#include "app/reports/log.hpp"
#include "app/reports/run_summary.hpp"
#include "core/base/diagnostics.hpp"
#include "core/base/errors.hpp"

namespace contactsim {

/// Takes a deck as far as the options ask: deck, mesh, contact surfaces, run.
///   ranks     that do it together
///   signals   that end a run, from its first part on
///   warnings  gains what was found on the way, to be repeated at the end
///   summary   gains what is known of deck, mesh, pairs and run, also when something is thrown
///   draft     the same for a report, if one is asked for
/// Throws DeckError, FileError, and StoppedBySignal before the first step.
ExitCode run_deck(const Options& options, Ranks& ranks, StopSignals& signals, Log& log, Diagnostics& warnings,
                  RunSummary& summary, ReportDraft& draft);

}  // namespace contactsim

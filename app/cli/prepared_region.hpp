// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/cli/options.hpp"
#include "app/cli/read_run_deck.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/report/report_draft.hpp"
#include "app/reports/log.hpp"
#include "app/reports/run_summary.hpp"
#include "app/run/run_input.hpp"
#include "core/base/diagnostics.hpp"
#include "core/base/errors.hpp"

namespace contactsim {

/// What the way from a deck to its run has at hand.
struct DeckWay {
  const Options& options;
  const SimulationDefinition& definition;
  Ranks& ranks;
  StopSignals& signals;
  Log& log;
  Diagnostics& warnings;
  RunSummary& summary;
  ReportDraft& draft;
};

/// Meshes by the finite element model that asks for them, null where none does: each is read once.
using MeshesByModel = std::map<const FiniteElementModel*, std::shared_ptr<Mesh>>;

/// The region of a procedure on its mesh, with its contact surfaces: what its run is made from.
struct PreparedRegion {
  const Procedure& procedure;
  const Region& region;
  std::shared_ptr<Mesh> mesh;
  std::optional<ContactModel> contact;
  std::vector<StartOverlap> overlaps;
  ExitCode code = ExitCode::done;  ///< of a file of surfaces that could not be written: it goes no further

  ///   definition  that it is of; both must outlive the run
  RunInput input(const SimulationDefinition& definition) const;
};

/// Reads the mesh, resolves the contact surfaces and removes overlap where the deck wants it.
///   chosen         must outlive what is prepared
///   meshes         that are known; gains this one
///   writes_tables  whether it is the region that files of surfaces are asked of
/// Throws DeckError, FileError, SolveError, and StoppedBySignal.
PreparedRegion prepare_region(const DeckWay& way, const ChosenRegion& chosen, MeshesByModel& meshes,
                              bool writes_tables);

}  // namespace contactsim

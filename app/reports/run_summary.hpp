// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/run/simulation.hpp"
#include "contact/enforcement/pair_history.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/overlap/interpenetration_watch.hpp"
#include "core/base/diagnostics.hpp"
#include "core/base/errors.hpp"
#include "core/dynamics/state.hpp"

namespace contactsim {

/// The mesh of a run, as it is in its file.
struct SummaryMesh {
  std::string path;
  std::string digest;  ///< of the file's bytes, 16 hexadecimal digits; "" when it cannot be read
  std::optional<std::uint32_t> n_nodes, n_elements;  ///< absent until it has been read
};

/// A pair of contact surfaces and, once there is a run, what it has done.
struct SummaryPair {
  std::uint32_t number = 0;  ///< as in the log, from 1
  std::string first, second, interaction;
  int line = 0;  ///< of the deck
  std::optional<PairHistory> history = {};
  std::optional<Interpenetration> interpenetration = {};
  std::optional<double> overlap_energy =
      {};  ///< that sides which overlapped may give out as they part [energy]
};

/// How far the run of a procedure has come.
struct SummaryRun {
  std::string procedure;
  std::int64_t n_steps = 0;
  double time = 0.0, termination_time = 0.0;  ///< [time]
  double stable_step = 0.0;                   ///< at the start, not scaled; 0: not known [time]
  double last_step = 0.0;                     ///< [time]
  Energies energies;
  std::optional<std::string> ended_by;  ///< a signal, a SOLUTION TERMINATION; absent: its termination time
  double seconds = 0.0;                 ///< of the clock; 0: not known
  std::vector<PartTime> parts;
};

/// What --summary writes about a run: what it was asked for and, as far as known, what came of it.
struct RunSummary {
  std::string stage = "run";  ///< that was asked for: parse, tables, check or run
  std::string deck;
  std::string deck_digest;  ///< of the deck and its includes, 16 hexadecimal digits; "" when not known
  std::vector<std::pair<std::string, std::string>> definitions;  ///< of -D
  int n_threads = 0;
  std::optional<SummaryMesh> mesh;
  std::optional<SummaryRun> run;         ///< of the last procedure that has begun
  std::vector<SummaryRun> earlier_runs;  ///< of those before it
  std::vector<SummaryPair> pairs;        ///< those that have touched, and others as long as there are few
  std::size_t n_pairs = 0;               ///< of all
  Diagnostics found;                     ///< warnings, and errors of the deck
  std::vector<std::string> error_lines;  ///< of files and of the solution, "error: ..."
  std::optional<ExitCode> exit_code;     ///< absent while the run lasts
};

/// The fingerprint of the bytes of files, one behind the other, as 16 hexadecimal digits; "" when one cannot
/// be read.
std::string digest_of_files(std::span<const std::string> paths);
/// A fingerprint as 16 hexadecimal digits.
std::string format_digest(std::uint64_t digest);

/// Takes over the pairs of a model, without histories.
void note_pairs(const ContactModel& model, RunSummary& summary);
/// Takes over how far a run is and what its pairs have done.
void note_run(const Simulation& run, RunSummary& summary);

/// The summary as JSON, as app/reports/summary.schema.json says. What is not known, not finite or not there
/// yet is null.
std::string format_summary(const RunSummary& summary);

}  // namespace contactsim

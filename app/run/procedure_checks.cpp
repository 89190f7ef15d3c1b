// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/procedure_checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "app/run/deck_files.hpp"
#include "app/run/file_clashes.hpp"
#include "core/definition/simulation.hpp"

namespace contactsim {

namespace {

int length_of(const DeckName& name) { return std::max(1, static_cast<int>(name.text.size())); }

void check_files(const SimulationDefinition& definition, Diagnostics& diagnostics) {
  std::vector<DeckFile> taken;
  for (const Procedure& procedure : definition.procedures) {
    std::vector<DeckFile> own = find_deck_files(definition, procedure);
    for (const DeckFile& file : own) {
      if (file.appends) continue;
      for (const DeckFile& other : taken) {
        const RunFile there{other.path, ""}, here{file.path, ""};
        if (find_file_clash({&there, 1}, {&here, 1}).empty()) continue;
        diagnostics.add_error(
            file.location,
            fmt::format("the procedure '{}' would overwrite {}, which a procedure before it "
                        "writes",
                        procedure.name.text, file.path),
            fmt::format("give it another name than at {}", to_string(other.location)));
        break;
      }
    }
    taken.insert(taken.end(), own.begin(), own.end());
  }
}

/// Warns of a state that is taken over at another time than it was reached at.
void check_times(const Procedure& before, const Procedure& procedure, Diagnostics& diagnostics) {
  if (!before.time_control || !procedure.time_control) return;
  const TimeControl& control = *procedure.time_control;
  if (control.time_stepping_blocks.empty()) return;
  const double end = before.time_control->termination_time;
  const double start = control.time_stepping_blocks.front().start_time;
  constexpr double round_off = 1e-9;
  if (!(std::abs(start - end) > round_off * std::max(std::abs(start), std::abs(end)))) return;
  diagnostics.add_warning(
      "procedure-times", control.time_stepping_blocks.front().name.location,
      fmt::format("the procedure '{}' starts at time {} with the state that '{}' comes to at {}",
                  procedure.name.text, start, before.name.text, end),
      "functions of time jump from one to the other");
}

void check_transfer(const Procedure& before, const Procedure& procedure, Diagnostics& diagnostics) {
  if (!procedure.transfers.empty()) return check_times(before, procedure, diagnostics);
  diagnostics.add_warning(
      "procedure-from-mesh", procedure.name.location,
      fmt::format("the procedure '{}' starts from the mesh: it takes over nothing from '{}'",
                  procedure.name.text, before.name.text),
      "BEGIN PROCEDURAL TRANSFER with INCLUDE ALL BLOCKS takes over its state", length_of(procedure.name));
}

}  // namespace

void check_procedures(const SimulationDefinition& definition, Diagnostics& diagnostics) {
  const std::vector<Procedure>& procedures = definition.procedures;
  if (procedures.empty()) return;
  for (const ProceduralTransfer& transfer : procedures.front().transfers)
    diagnostics.add_error(
        transfer.name.location,
        fmt::format("there is no procedure before '{}' whose state could be taken over",
                    procedures.front().name.text),
        "procedures run in the order of the deck; the one that takes over stands behind the other");
  for (std::size_t i = 1; i < procedures.size(); ++i)
    check_transfer(procedures[i - 1], procedures[i], diagnostics);
  if (procedures.size() < 2) return;
  check_files(definition, diagnostics);
}

}  // namespace contactsim

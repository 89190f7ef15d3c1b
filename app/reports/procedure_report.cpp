// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/procedure_report.hpp"

#include <fmt/format.h>

#include "core/definition/procedure.hpp"

namespace contactsim {

namespace {

std::string format_times(const TimeControl& control) {
  if (control.time_stepping_blocks.empty()) return "";
  return fmt::format(", time {:.6g} to {:.6g}", control.time_stepping_blocks.front().start_time,
                     control.termination_time);
}

/// "all blocks", "the blocks a, b", "all blocks but c".
std::string format_blocks(const ProceduralTransfer& transfer) {
  const auto list = [](const std::vector<DeckName>& names) {
    std::string text;
    for (const DeckName& name : names) text += (text.empty() ? "" : ", ") + name.text;
    return text;
  };
  std::string text =
      transfer.set.includes_all_blocks ? "all blocks" : "the blocks " + list(transfer.set.blocks);
  if (!transfer.set.removed_blocks.empty()) text += " but " + list(transfer.set.removed_blocks);
  return text;
}

}  // namespace

std::string format_procedure(const Procedure& procedure, const Region& region, const Procedure* before) {
  std::string text = fmt::format("\nProcedure {}: {}, region {}{}\n", procedure.name.text,
                                 procedure.implicit_by ? "quasi-static" : "explicit", region.name.text,
                                 procedure.time_control ? format_times(*procedure.time_control) : "");
  if (before == nullptr) return text;
  for (const ProceduralTransfer& transfer : procedure.transfers)
    text += fmt::format("  takes over the state of {} from {}\n", format_blocks(transfer), before->name.text);
  if (procedure.transfers.empty()) text += "  starts from the mesh\n";
  return text;
}

}  // namespace contactsim

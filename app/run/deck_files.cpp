// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/deck_files.hpp"

#include <optional>

#include "app/run/contact_debug.hpp"
#include "core/definition/simulation.hpp"
#include "core/output/planned_files.hpp"

namespace contactsim {

std::vector<DeckFile> find_deck_files(const SimulationDefinition& definition, const Procedure& procedure) {
  using Kind = DeckFile::Kind;
  std::vector<DeckFile> files;
  const auto add = [&](const DeckName& block, const std::optional<DeckName>& name, const char* other,
                       Kind kind = Kind::other, bool appends = false) {
    files.push_back({expand_file_name(definition, name ? name->text : other),
                     name ? name->location : block.location, kind, appends});
  };
  for (const Region& region : procedure.regions) {
    for (const ResultsOutput& output : region.results_outputs)
      add(output.name, output.database.name, "%B.e", Kind::results);
    for (const HistoryOutput& output : region.history_outputs) add(output.name, output.database.name, "%B.h");
    for (const HeartbeatOutput& output : region.heartbeat_outputs)
      if (!goes_to_log(output)) add(output.name, output.stream, "%B.csv", Kind::other, output.appends);
    for (const RestartData& restart : region.restart_data)
      add(restart.name, restart.output_database ? restart.output_database : restart.database, "%B.rsout",
          Kind::states);
    if (!region.contact) continue;
    for (const std::string& path : contact_debug_files(definition, region.contact->debug).paths())
      files.push_back({path, region.contact->name.location});
  }
  return files;
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/cli/prepared_region.hpp"
#include "core/definition/simulation.hpp"
#include "parser/deck.hpp"
#include "support/exodus_file.hpp"
#include "support/temporary_directory.hpp"

namespace contactsim::test {

/// What the way from a deck to its run has at hand, in a directory of its own: the mesh m.g, the quiet log
/// a.log. The deck is "d.i" and on no file.
struct StagedDeck : TemporaryDirectory {
  StagedDeck(const Mesh& mesh, const std::string& deck)
      : definition(parse_deck_text("d.i", deck, {}, warnings)), log(file("a.log"), true) {
    write_exodus(file("m.g"), mesh);
    options.deck = "d.i";
    options.mesh = file("m.g");
    log.begin(false);
  }
  DeckWay way() { return {options, definition, one_rank(), signals, log, warnings, summary, draft}; }
  std::vector<ChosenRegion> chosen() { return choose_regions(definition, false, warnings); }
  std::string logged() const { return read_bytes(file("a.log")); }

  Diagnostics warnings;
  Options options;
  SimulationDefinition definition;
  StopSignals signals;
  Log log;
  RunSummary summary;
  ReportDraft draft;
};

}  // namespace contactsim::test

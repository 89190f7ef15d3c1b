// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

#include "core/definition/simulation.hpp"
#include "parser/deck.hpp"

namespace contactsim::test {

/// A deck with one region of these lines.
inline SimulationDefinition deck_of_region(const std::string& lines) {
  Diagnostics found;
  const std::string text =
      "begin sierra a deck\nbegin finite element model m\nend\nbegin presto procedure p\nbegin time control\n"
      "begin time stepping block b\nstart time = 0\nend\ntermination time = 1\nend\nbegin presto region r\n"
      "use finite element model m\n" +
      lines + "\nend\nend\nend\n";
  SimulationDefinition definition = parse_deck_text("d.i", text, {{}, true}, found);
  for (const Diagnostic& one : found.all()) {
    if (one.severity == Severity::error) throw std::logic_error(one.text);
  }
  return definition;
}

inline const Region& region_of(const SimulationDefinition& definition) {
  return definition.procedures.front().regions.front();
}

}  // namespace contactsim::test

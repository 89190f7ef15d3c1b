// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/run_curves.hpp"
#include "core/base/deck_location.hpp"
#include "core/definition/simulation.hpp"

namespace contactsim {

/// What a run leaves for its report, as far as it has come.
struct ReportDraft {
  std::vector<SourceFile> deck;  ///< and its includes
  std::optional<SimulationDefinition> definition;
  std::optional<Region> region;  ///< that is run
  bool has_mesh = false;         ///< it could be read
  std::string surfaces;          ///< of format_surfaces_json; "" until they are resolved
  std::vector<std::string> output_paths;
  RunCurves curves;
};

}  // namespace contactsim

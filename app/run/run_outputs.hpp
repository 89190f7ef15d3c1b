// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/run/run_contact.hpp"
#include "app/run/run_input.hpp"
#include "core/output/output_plan.hpp"

namespace contactsim {

/// What the outputs of a run need besides deck and model.
///   model           of the run
///   contact         null without contact
///   complete_state  OutputSettings::complete_state
OutputSettings output_settings(
    const RunInput& input, const RunSettings& settings, const Model& model, RunContact* contact,
    std::function<void()> complete_state = [] {});

/// Warns of results of an earlier run that stay where this one writes pieces ("results-beside-pieces"):
/// readers of the name would take them.
///   paths  of all outputs
void warn_of_results_beside_pieces(const std::vector<std::string>& paths, Diagnostics& warnings);

/// No output may replace a file that is to be kept, and all must be writable: throws FileError.
void check_output_paths(const std::vector<RunFile>& kept, const std::vector<std::string>& paths);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/log.hpp"
#include "app/run_contact.hpp"
#include "app/transient.hpp"
#include "core/output/output_plan.hpp"

namespace contactsim {

/// What the outputs of a run need besides deck and model.
///   contact  null without contact
OutputSettings output_settings(const RunInput& input, RunContact* contact, Log& log);

/// No output may overwrite what the run reads, or the log: throws FileError.
void check_output_paths(const RunInput& input, const std::vector<std::string>& paths);

}  // namespace contactsim

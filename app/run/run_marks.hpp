// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/run/run_input.hpp"
#include "core/base/state_archive.hpp"
#include "core/dynamics/model.hpp"

namespace contactsim {

/// A part of the deck that a stored state stands on but does not hold, and its fingerprint.
struct RunMark {
  std::string what;  ///< for people: "the material 'steel'"
  DeckLocation location;
  std::uint64_t digest = 0;
};

/// Of materials with the functions that they name, of the elements and sections of blocks, and of the laws
/// and enforcement of contact pairs. Loads, times, outputs and solvers may change from run to run.
std::vector<RunMark> find_run_marks(const RunInput& input, const Model& model);

/// Saves the marks, or returns those that are not as they were in the run that saved them; what that run did
/// not have, or did not save, is passed over.
std::vector<RunMark> archive(const std::vector<RunMark>& marks, StateArchive& saved);

}  // namespace contactsim

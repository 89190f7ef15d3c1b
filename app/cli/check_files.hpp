// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "app/cli/options.hpp"
#include "app/cli/read_run_deck.hpp"

namespace contactsim {

/// What would be lost if a run wrote its files, asked before the first byte is written: a file that is read,
/// the deck, what it includes and the meshes that it names; one that is written under two names, by the
/// command line and by the deck; a state of a restart. "" when all is well.
std::string find_clash_of_run(const Options& options, const RunDeck& deck);

/// Warns of files that the deck writes outside the folder that the run is started in.
void warn_of_files_outside(const Options& options, const RunDeck& deck, Diagnostics& warnings);

}  // namespace contactsim

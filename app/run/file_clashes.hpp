// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

namespace contactsim {

/// A file of a run and what it is to the user: "the deck", "the log", "the file of --surfaces-csv".
struct RunFile {
  std::string path;
  std::string what;
};

/// What would be lost if the run wrote its files: one that it reads, or one that it writes under two names.
/// Devices such as /dev/null lose nothing. "" when all is well.
std::string find_file_clash(std::span<const RunFile> read, std::span<const RunFile> written);

/// Why a file cannot be written: its folder is not there or not writable, or it is a folder itself. "" when
/// it can. Touches nothing.
std::string find_write_obstacle(const std::string& path);

}  // namespace contactsim

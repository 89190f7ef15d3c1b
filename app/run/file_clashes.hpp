// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <string>

#include "io/files/file_lock.hpp"

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

/// Keeps a file that has been begun for this run. Throws FileError when another run writes it.
std::shared_ptr<FileLock> lock_output(const std::string& path);

/// Throws FileError when a file is there that may not be replaced, or that another run writes.
void refuse_to_replace(const std::string& path, bool overwrites);

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/file_clashes.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <filesystem>
#include <vector>

#include "core/base/errors.hpp"
#include "core/base/file_paths.hpp"

namespace contactsim {

namespace fs = std::filesystem;

namespace {

/// Whether one of two files that are both written would destroy the other.
bool do_clash(const std::string& one, const std::string& other) {
  return would_overwrite(one, other) || would_overwrite(other, one);
}

std::string describe_clash(const RunFile& file, const RunFile& other) {
  return fmt::format("{} would overwrite {}, {}", file.what, other.what, other.path);
}

}  // namespace

std::string find_file_clash(std::span<const RunFile> read, std::span<const RunFile> written) {
  std::vector<RunFile> taken;
  for (const RunFile& file : written) {
    if (is_device(file.path)) continue;
    for (const RunFile& other : read) {
      if (would_overwrite(file.path, other.path)) return describe_clash(file, other);
    }
    for (const RunFile& other : taken) {
      if (do_clash(file.path, other.path)) return describe_clash(file, other);
    }
    taken.push_back(file);
  }
  return "";
}

std::string find_write_obstacle(const std::string& path) {
  std::error_code ignored;
  const fs::path file(path);
  if (fs::is_directory(file, ignored)) return "this is a folder, no file can be written there";
  if (fs::exists(file, ignored))
    return access(path.c_str(), W_OK) == 0 ? "" : "the file is there and may not be written";
  const fs::path folder = folder_of(file);
  if (!fs::is_directory(folder, ignored))
    return fmt::format("there is no folder '{}' to write it to", folder.string());
  return access(folder.c_str(), W_OK) == 0
             ? ""
             : fmt::format("the folder '{}' may not be written", folder.string());
}

std::shared_ptr<FileLock> lock_output(const std::string& path) {
  return std::make_shared<FileLock>(path, "the deck or the command line can name another file");
}

void refuse_to_replace(const std::string& path, bool overwrites) {
  std::error_code ignored;
  if (!overwrites && fs::exists(path, ignored))
    throw FileError(path, "exists, and the deck says OVERWRITE = OFF");
  lock_output(path);
}

}  // namespace contactsim

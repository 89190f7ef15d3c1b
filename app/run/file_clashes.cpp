// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/file_clashes.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <filesystem>
#include <vector>

namespace contactsim {

namespace {

namespace fs = std::filesystem;

bool is_device(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

fs::path whole_path(const fs::path& path) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(path, ignored), ignored);
}

/// Links are followed; of files that are not there yet the paths count.
bool is_same_file(const fs::path& one, const fs::path& other) {
  std::error_code ignored;
  return fs::equivalent(one, other, ignored) || whole_path(one) == whole_path(other);
}

}  // namespace

std::string find_file_clash(std::span<const RunFile> read, std::span<const RunFile> written) {
  std::vector<RunFile> taken(read.begin(), read.end());
  for (const RunFile& file : written) {
    if (is_device(file.path)) continue;
    for (const RunFile& other : taken) {
      if (is_same_file(file.path, other.path)) {
        return fmt::format("{} would overwrite {}, {}", file.what, other.what, other.path);
      }
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
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!fs::is_directory(folder, ignored))
    return fmt::format("there is no folder '{}' to write it to", folder.string());
  return access(folder.c_str(), W_OK) == 0
             ? ""
             : fmt::format("the folder '{}' may not be written", folder.string());
}

}  // namespace contactsim

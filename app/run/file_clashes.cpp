// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/file_clashes.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <filesystem>
#include <vector>

#include "io/files/file_links.hpp"

namespace contactsim {

namespace {

namespace fs = std::filesystem;

/// Links are followed; of files that are not there yet folder and name count. No path is made absolute, as
/// that of the working folder may be too long.
bool is_same_file(const fs::path& one, const fs::path& other) {
  std::error_code ignored;
  if (fs::equivalent(one, other, ignored)) return true;
  const fs::path a = follow_links(one), b = follow_links(other);
  if (a.filename() != b.filename()) return false;
  return fs::equivalent(folder_of(a), folder_of(b), ignored) || a.lexically_normal() == b.lexically_normal();
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
  const fs::path folder = folder_of(file);
  if (!fs::is_directory(folder, ignored))
    return fmt::format("there is no folder '{}' to write it to", folder.string());
  return access(folder.c_str(), W_OK) == 0
             ? ""
             : fmt::format("the folder '{}' may not be written", folder.string());
}

}  // namespace contactsim

// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/file_paths.hpp"

#include <algorithm>
#include <system_error>

#include "core/base/errors.hpp"

namespace contactsim {

namespace fs = std::filesystem;

namespace {

bool is_below(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : "."; }

bool is_device(const fs::path& path) {
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) return true;
  const fs::path folder = fs::canonical(folder_of(path), failure);
  return !failure && (is_below(folder, "/dev") || is_below(folder, "/proc"));
}

fs::path follow_links(fs::path path) {
  constexpr int max_links = 40;  // as many as Linux follows
  if (is_device(path)) return path;
  std::error_code failure;
  for (int i = 0; i < max_links && fs::is_symlink(path, failure); ++i) {
    const fs::path target = fs::read_symlink(path, failure);
    path = target.is_absolute() ? target : path.parent_path() / target;
  }
  return path;
}

bool is_same_file(const fs::path& one, const fs::path& other) {
  std::error_code ignored;
  if (fs::equivalent(one, other, ignored)) return true;
  const fs::path a = follow_links(one), b = follow_links(other);
  if (a.filename() != b.filename()) return false;
  // No path is made absolute, as that of the working folder may be too long.
  return fs::equivalent(folder_of(a), folder_of(b), ignored) || a.lexically_normal() == b.lexically_normal();
}

std::string unfinished_name(const std::string& path) { return follow_links(path).string() + ".part"; }

bool would_overwrite(const std::string& written, const std::string& other) {
  return is_same_file(written, other) || is_same_file(unfinished_name(written), other);
}

void refuse_link_out_of_folder(const std::string& path) {
  std::error_code failure;
  if (!fs::is_symlink(path, failure) || is_device(path)) return;
  const fs::path target = follow_links(path);
  const fs::path folder = fs::canonical(folder_of(path), failure);
  const fs::path target_folder = failure ? fs::path{} : fs::weakly_canonical(folder_of(target), failure);
  if (!failure && is_below(target_folder, folder)) return;
  throw FileError(path, "is a link to '" + target.string() +
                            "', outside its folder: remove the link, or give the run that name");
}

}  // namespace contactsim

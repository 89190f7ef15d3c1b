// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/same_file.hpp"

#include <system_error>

namespace contactsim {

namespace fs = std::filesystem;

namespace {

/// Where links lead, also to what is not there yet, of which weakly_canonical() knows nothing.
fs::path follow(fs::path path) {
  constexpr int max_links = 40;  // as Linux has it
  std::error_code error;
  for (int i = 0; i < max_links && fs::is_symlink(path, error); ++i) {
    const fs::path next = fs::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / next;
  }
  return path;
}

fs::path whole_path(const fs::path& path) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(follow(path), ignored), ignored);
}

}  // namespace

bool is_same_file(const fs::path& one, const fs::path& other) {
  std::error_code ignored;
  return fs::equivalent(one, other, ignored) || whole_path(one) == whole_path(other);
}

std::string link_target(const std::string& path) {
  std::error_code ignored;
  const fs::path pointed_to = fs::is_symlink(path, ignored) ? whole_path(path) : fs::path(path);
  return pointed_to.empty() ? path : pointed_to.string();
}

std::string unfinished_name(const std::string& path) { return link_target(path) + ".part"; }

bool would_overwrite(const std::string& written, const std::string& other) {
  return is_same_file(written, other) || is_same_file(unfinished_name(written), other);
}

}  // namespace contactsim

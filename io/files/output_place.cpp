// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/output_place.hpp"

#include <filesystem>
#include <system_error>

#include "core/base/file_paths.hpp"

namespace contactsim {

namespace fs = std::filesystem;

OutputPlace::OutputPlace(const std::string& path) : target_(follow_links(path).string()) {
  refuse_link_out_of_folder(path);
  std::error_code error;
  const bool writes_as_it_is = is_device(target_);
  unfinished_ = writes_as_it_is ? target_ : unfinished_name(target_);
  // A link in its place would be followed.
  if (!writes_as_it_is && fs::is_symlink(unfinished_, error)) fs::remove(unfinished_, error);
}

std::string OutputPlace::commit() const {
  if (!is_regular()) return "";
  std::error_code error;
  fs::rename(unfinished_, target_, error);
  if (!error) return "";
  discard();
  return error.message();
}

void OutputPlace::discard() const {
  if (!is_regular()) return;
  std::error_code ignored;
  fs::remove(unfinished_, ignored);
}

}  // namespace contactsim
